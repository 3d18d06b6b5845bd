// Method svd, in its band, against the paper's chain over the whole frame: time and centres. Prints a table.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>
#include <opencv2/core/utility.hpp>

#include "reference/plain_svd.h"
#include "support/render_stripe.h"
#include "weld_profiler/stripe/stripe_stage.h"

namespace
{
using weld_profiler::InitialPoint;
using weld_profiler::Stripe;
using weld_profiler::StripeParams;
using weld_profiler::StripeStage;
using weld_profiler::Workspace;
using weld_profiler::reference::PlainCentre;
using weld_profiler::reference::plainSvd;
using weld_profiler::test_support::Picture;
using weld_profiler::test_support::StripePicture;

constexpr double kHessianSigma = 2.25;

Picture frame(unsigned seed)
{
  StripePicture scene;
  scene.width = 1440;
  scene.height = 1080;
  scene.snr = 50.0;
  scene.seed = seed;
  scene.row = [seed](double u)
  { return 540.0 + 3.0 * seed + 60.0 * std::exp(-std::pow((u - 720.0) / 120.0, 2.0)) + 0.05 * u; };
  return render(scene);
}

cv::Mat matOf(const Picture& picture)
{
  return { picture.height, picture.width, CV_8U, const_cast<std::uint8_t*>(picture.bytes.data()) };
}

template <class Work>
double medianMicroseconds(int runs, Work&& work)
{
  std::vector<double> times;
  for (int i = 0; i < runs; ++i)
  {
    const auto begin = std::chrono::steady_clock::now();
    work(static_cast<std::size_t>(i));
    times.push_back(std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begin).count());
  }
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

struct Agreement
{
  std::size_t cells = 0, within = 0;
  double largest = 0.0;  ///< of those within [px]
};

/// From the same initial points, cell by cell.
Agreement compare(const StripeStage& stage, const Picture& picture)
{
  Workspace workspace;
  workspace.keep_trace = true;
  Stripe stripe;
  stage.process(picture.raw(), workspace, stripe);
  std::vector<double> rows(static_cast<std::size_t>(picture.width), std::numeric_limits<double>::quiet_NaN());
  for (const InitialPoint& point : workspace.initial)
    rows[static_cast<std::size_t>(point.u)] = point.v;
  const std::vector<PlainCentre> plain = plainSvd(matOf(picture), kHessianSigma, rows);
  Agreement result;
  for (std::size_t i = 0; i < std::min(plain.size(), stripe.size()); ++i)
  {
    const double difference = std::hypot(plain[i].u - stripe.u[i], plain[i].v - stripe.v[i]);
    ++result.cells;
    if (difference > 1e-4)
      continue;
    ++result.within;
    result.largest = std::max(result.largest, difference);
  }
  return result;
}
}  // namespace

int main()
{
  cv::setNumThreads(1);
  StripeParams params;
  params.method = "svd";
  params.direction = "u";
  params.hessian_sigma_px = kHessianSigma;
  params.max_gap_px = 0;
  const StripeStage stage(params);
  std::vector<Picture> frames;
  for (unsigned seed = 1; seed <= 6; ++seed)
    frames.push_back(frame(seed));

  Workspace workspace;
  Stripe stripe;
  const double in_band = medianMicroseconds(
      121, [&](std::size_t i) { stage.process(frames[i % frames.size()].raw(), workspace, stripe); });
  std::size_t centres = 0;
  const double plain = medianMicroseconds(
      21, [&](std::size_t i) { centres += plainSvd(matOf(frames[i % frames.size()]), kHessianSigma).size(); });
  Agreement sum;
  for (const Picture& picture : frames)
  {
    const Agreement one = compare(stage, picture);
    sum.cells += one.cells;
    sum.within += one.within;
    sum.largest = std::max(sum.largest, one.largest);
  }
  std::printf("1440x1080, sigma 2 px, SNR 50, derivatives of %.2f px, one thread, frames in turn\n\n", kHessianSigma);
  std::printf("| | us a frame | ratio |\n|---|---|---|\n| `svd`, in the band | %.0f | 1 |\n", in_band);
  std::printf("| the same over the whole frame, OpenCV and Eigen | %.0f | %.0f |\n\n", plain, plain / in_band);
  std::printf("the same centre within 1e-4 px in %.2f %% of %zu cells (largest of them %.1e px)\n",
              100.0 * static_cast<double>(sum.within) / static_cast<double>(sum.cells), sum.cells, sum.largest);
  return centres == 0 ? 1 : 0;
}
