// Accuracy of every stripe method on ideal stripes, as tables for docs/paper.md. Prints to standard output.
#include <cmath>
#include <cstdio>
#include <functional>

#include "comparison/bound.h"
#include "support/extract.h"

namespace
{
using weld_profiler::Stripe;
using weld_profiler::StripeParams;
using weld_profiler::StripeStage;
using weld_profiler::Workspace;
using weld_profiler::test_support::paramsOf;
using weld_profiler::test_support::Picture;
using weld_profiler::test_support::render;
using weld_profiler::test_support::straight;
using weld_profiler::test_support::StripePicture;

const double kDegree = std::acos(-1.0) / 180.0;
const double kSlopes[] = { 0.0, 15.0, 30.0, 45.0, 60.0 };
constexpr double kTurn = 6.28318530717958648;
constexpr int kRuns = 8;

struct Score
{
  double squares = 0.0, normals = 0.0, in_sigmas = 0.0;
  std::size_t count = 0, cells = 0;

  void add(const StripePicture& scene, const Stripe& stripe)
  {
    cells += static_cast<std::size_t>(scene.width);
    for (std::size_t i = 0; i < stripe.size(); ++i)
    {
      if ((stripe.flags[i] & weld_profiler::stripe_flag::kInterpolated) != 0)
        continue;
      const double error = distanceAcross(scene, stripe.u[i], stripe.v[i]);
      const double slope = (scene.row(stripe.u[i] + 0.01) - scene.row(stripe.u[i] - 0.01)) / 0.02;
      const double normal = std::remainder(stripe.normal_angle[i] - std::atan2(1.0, -slope), 180.0 * kDegree) / kDegree;
      squares += error * error;
      normals += normal * normal;
      in_sigmas += error * error / (stripe.sigma[i] * stripe.sigma[i]);
      ++count;
    }
  }
  double rmseMpx() const { return 1000.0 * std::sqrt(squares / static_cast<double>(count)); }
  double normalDegrees() const { return std::sqrt(normals / static_cast<double>(count)); }
  double sigmas() const { return std::sqrt(in_sigmas / static_cast<double>(count)); }
  double kept() const { return 100.0 * static_cast<double>(count) / static_cast<double>(cells); }
};

StripePicture slopedScene(double degrees, int run)
{
  // Off the whole degrees, so that every sub-pixel offset occurs.
  StripePicture scene = straight(degrees + 0.17, 20.0 + 0.1237 * (run + 0.5));
  scene.width = 300;
  scene.height = static_cast<int>(42.0 + 300.0 * std::tan((degrees + 0.17) * kDegree));
  scene.snr = 50.0;
  scene.seed = 100U + static_cast<unsigned>(run);
  return scene;
}

Score measure(
    const StripeParams& params, double degrees,
    const std::function<void(StripePicture&)>& change = [](StripePicture&) {})
{
  Score score;
  const StripeStage stage(params);
  Workspace workspace;
  Stripe stripe;
  for (int run = 0; run < kRuns; ++run)
  {
    StripePicture scene = slopedScene(degrees, run);
    change(scene);
    stage.process(render(scene).raw(), workspace, stripe);
    score.add(scene, stripe);
  }
  return score;
}

/// Cramer-Rao bound of one column, across the stripe.
double boundMpx(double degrees)
{
  const StripePicture scene = slopedScene(degrees, 0);
  const double slope = std::tan((degrees + 0.17) * kDegree);
  return 1000.0 *
         weld_profiler::comparison::Bound({ scene.sigma, slope, scene.peak, scene.background, scene.snr, scene.clip })
             .ofColumns(1);
}

/// 45 deg flanks, curvature up to 0.03 / px.
StripePicture beadScene(double snr)
{
  StripePicture scene;
  scene.width = 400;
  scene.height = 160;
  scene.snr = snr;
  // a sine with slope 1 and curvature 2 pi / 210 = 0.03 / px
  scene.row = [](double u) { return 80.3 + 210.0 / kTurn * std::sin(kTurn * u / 210.0); };
  return scene;
}

Score measureBead(const StripeParams& params, double snr)
{
  Score score;
  const StripePicture scene = beadScene(snr);
  Workspace workspace;
  Stripe stripe;
  StripeStage(params).process(render(scene).raw(), workspace, stripe);
  score.add(scene, stripe);
  return score;
}

void printAccuracy()
{
  std::printf("sigma 2 px, SNR 50: RMSE across the stripe [mpx] / normal [deg], slopes 0 15 30 45 60 deg\n");
  std::printf("%-34s", "bound of one column");
  for (const double degrees : kSlopes)
    std::printf("  %5.1f       ", boundMpx(degrees));
  std::printf("\n");
  for (const std::string& method : weld_profiler::stripeMethods())
  {
    std::printf("%-34s", method.c_str());
    double sigmas = 0.0;
    for (const double degrees : kSlopes)
    {
      const Score score = measure(paramsOf(method), degrees);
      std::printf("  %5.1f / %5.2f", score.rmseMpx(), score.normalDegrees());
      sigmas += score.sigmas() / 5.0;
    }
    std::printf("   error / told sigma %.2f\n", sigmas);
  }
}

/// The paper to the letter, and what each departure from it brings.
void printReadings()
{
  struct Reading
  {
    const char* name;
    const char* method;
    const char* taylor;
    const char* derivatives;
    int median;
  };
  for (const Reading& reading : { Reading{ "svd literal, sobel, median 3", "svd", "literal", "sobel", 3 },
                                  Reading{ "svd literal, sobel, no median", "svd", "literal", "sobel", 0 },
                                  Reading{ "svd literal, gaussian, median 3", "svd", "literal", "gaussian", 3 },
                                  Reading{ "svd sound, sobel", "svd", "sound", "sobel", 3 },
                                  Reading{ "pca literal, sobel, median 3", "pca", "literal", "sobel", 3 } })
  {
    StripeParams params = paramsOf(reading.method);
    params.taylor = reading.taylor;
    params.derivatives = reading.derivatives;
    params.median_size_px = reading.median;
    params.max_gap_px = 0;
    std::printf("%-34s", reading.name);
    for (const double degrees : kSlopes)
    {
      const Score score = measure(params, degrees);
      std::printf("  %5.1f / %5.2f", score.rmseMpx(), score.normalDegrees());
    }
    std::printf("   kept at 0 deg %.0f %%, at 45 deg %.0f %%\n", measure(params, 0.0).kept(),
                measure(params, 45.0).kept());
  }
}

void printHardScenes()
{
  std::printf("\nRMSE across the stripe [mpx]\n%-20s %9s %9s %9s %9s %9s %9s %9s\n", "", "bead", "bead", "speckle",
              "speckle", "gain", "clipped", "clipped");
  std::printf("%-20s %9s %9s %9s %9s %9s %9s %9s\n", "", "no noise", "SNR 50", "0.1, 15deg", "0.2, 15deg", "40%,45deg",
              "peak 300", "peak 1000");
  for (const std::string& method : weld_profiler::stripeMethods())
  {
    const StripeParams params = paramsOf(method);
    const auto speckle = [&](double contrast)
    { return measure(params, 15.0, [=](StripePicture& scene) { scene.speckle = contrast; }).rmseMpx(); };
    const auto clipped = [&](double peak)
    { return measure(params, 15.0, [=](StripePicture& scene) { scene.peak = peak; }).rmseMpx(); };
    const double gain =
        measure(params, 45.0,
                [](StripePicture& scene)
                {
                  scene.peak = 150.0;
                  scene.gain = [](double u) { return 1.0 + 0.4 * std::sin(2.0 * 3.14159265 * u / 20.0); };
                })
            .rmseMpx();
    std::printf("%-20s %9.1f %9.1f %9.1f %9.1f %9.1f %9.1f %9.1f\n", method.c_str(), measureBead(params, 0.0).rmseMpx(),
                measureBead(params, 50.0).rmseMpx(), speckle(0.1), speckle(0.2), gain, clipped(300.0), clipped(1000.0));
  }
}

/// Centres of the bead lost in breaks of a given length, every 50 columns.
void printRepair()
{
  std::printf(
      "\nrepair of breaks on the bead, squared_centroid: RMSE [mpx] / filled of lost [%%] / error over told sigma\n");
  for (const char* reading : { "sound", "literal" })
  {
    std::printf("%-20s", reading[0] == 's' ? "least squares" : "interpolating");
    for (const int gap : { 2, 5, 10, 20 })
    {
      StripeParams params = paramsOf("squared_centroid");
      params.taylor = reading;
      double squares = 0.0, in_sigmas = 0.0;
      int filled = 0, lost = 0;
      for (unsigned run = 0; run < 6; ++run)
      {
        StripePicture scene = beadScene(50.0);
        scene.seed = run + 1;
        Picture picture = render(scene);
        for (int u = 40; u + gap < scene.width - 20; u += 50, lost += gap)
          for (int i = u; i < u + gap; ++i)
            for (int v = 0; v < scene.height; ++v)
              picture.set(i, v, scene.background);
        Workspace workspace;
        Stripe stripe;
        StripeStage(params).process(picture.raw(), workspace, stripe);
        for (std::size_t i = 0; i < stripe.size(); ++i)
        {
          if ((stripe.flags[i] & weld_profiler::stripe_flag::kInterpolated) == 0)
            continue;
          const double error = distanceAcross(scene, stripe.u[i], stripe.v[i]);
          squares += error * error;
          in_sigmas += std::pow(error / stripe.sigma[i], 2.0);
          ++filled;
        }
      }
      std::printf("  gap %2d: %5.1f / %3.0f / %.2f", gap, 1000.0 * std::sqrt(squares / filled), 100.0 * filled / lost,
                  std::sqrt(in_sigmas / filled));
    }
    std::printf("\n");
  }
}
}  // namespace

int main()
{
  printAccuracy();
  printReadings();
  printHardScenes();
  printRepair();
  return 0;
}
