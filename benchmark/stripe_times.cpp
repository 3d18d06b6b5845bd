// Time of every stripe method a frame, as a table for docs/paper.md. Prints to standard output.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <numeric>

#include "support/render_stripe.h"
#include "weld_profiler/stripe/stripe_methods.h"
#include "weld_profiler/stripe/stripe_stage.h"

namespace
{
using weld_profiler::Stripe;
using weld_profiler::StripeParams;
using weld_profiler::StripeStage;
using weld_profiler::Workspace;
using weld_profiler::test_support::Picture;
using weld_profiler::test_support::StripePicture;

StripeParams paramsOf(const std::string& method)
{
  StripeParams params;
  params.method = method;
  params.direction = "u";
  return params;
}

template <class Work>
double medianSeconds(Work&& work)
{
  std::vector<double> seconds;
  for (int i = 0; i < 61; ++i)
  {
    const auto begin = std::chrono::steady_clock::now();
    work(i);
    seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  }
  std::sort(seconds.begin(), seconds.end());
  return seconds[seconds.size() / 2];
}

void printTimes()
{
  // A few frames in turn, so that no frame lies in the cache from the round before.
  std::vector<Picture> frames;
  for (unsigned i = 0; i < 6; ++i)
  {
    StripePicture scene;
    scene.width = 1440;
    scene.height = 1080;
    scene.snr = 50.0;
    scene.seed = i + 1;
    scene.row = [i](double u)
    { return 540.0 + 3.0 * i + 60.0 * std::exp(-std::pow((u - 720.0) / 120.0, 2.0)) + 0.05 * u; };
    frames.push_back(render(scene));
  }
  unsigned long sum = 0;
  const double read = medianSeconds(
      [&](int i)
      {
        const Picture& frame = frames[static_cast<std::size_t>(i) % frames.size()];
        sum += std::accumulate(frame.bytes.begin(), frame.bytes.end(), 0U);
      });
  std::printf("\none frame of 1440x1080, mono8, one thread: median time, ratio to one read of it (%.3f ms, sum %lu)\n",
              1e3 * read, sum);
  const auto time = [&](const char* name, const StripeParams& params)
  {
    const StripeStage stage(params);
    Workspace workspace;
    Stripe stripe;
    const double seconds = medianSeconds(
        [&](int i) { stage.process(frames[static_cast<std::size_t>(i) % frames.size()].raw(), workspace, stripe); });
    std::printf("%-34s %7.2f ms %7.1f\n", name, 1e3 * seconds, seconds / read);
  };
  for (const std::string& method : weld_profiler::stripeMethods())
    time(method.c_str(), paramsOf(method));
  StripeParams literal = paramsOf("svd");
  literal.taylor = "literal";
  literal.derivatives = "sobel";
  time("svd literal, sobel", literal);
  StripeParams turned = paramsOf("squared_centroid");
  turned.direction = "v";
  time("squared_centroid, v, no stripe", turned);
}
}  // namespace

int main()
{
  printTimes();
  return 0;
}
