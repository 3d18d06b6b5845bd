// Time a frame of every method, held against one SIMD sum of the same frame, both measured in turn.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <map>

#include <opencv2/core/utility.hpp>

#include "comparison/context.h"
#include "comparison/ghosts.h"
#include "comparison/simd_sum.h"

namespace weld_profiler
{
namespace comparison
{
using test_support::Picture;

namespace
{
constexpr double kCycleBytes = 100e6;  ///< of frames gone through in turn: more than a cache holds
constexpr double kBudget = 1.2;        ///< for one measurement [s]
constexpr int kWarmTurn = 8;
constexpr std::size_t kLeastRounds = 31, kMostRounds = 1500;

struct Size
{
  int width, height;
};

/// A weld that sways by 3 px, closed in itself, each frame with noise of its own.
std::vector<Picture> framesOf(const Size& size)
{
  const auto count = static_cast<int>(std::ceil(kCycleBytes / (1.0 * size.width * size.height)));
  std::vector<Picture> frames;
  for (int i = 0; i < count; ++i)
  {
    test_support::StripePicture scene = weldScene(size.width, size.height);
    const auto row = scene.row;
    const double sway = 3.0 * std::sin(2.0 * 3.14159265358979 * i / count);
    scene.row = [=](double u) { return row(u) + sway; };
    scene.seed = 5000U + static_cast<unsigned>(i);
    frames.push_back(render(scene));
  }
  return frames;
}

/// Medians over rounds [s], and the quartiles of the contestant's.
struct Timing
{
  double sum = 0.0, own = 0.0, low = 0.0, high = 0.0;
  double ratio() const { return own / sum; }
};

double quantile(std::vector<double>& values, double share)
{
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// Time this thread has had a core: what other programs take of the machine does not count, but for the caches.
double onCore()
{
  std::timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

template <class Work>
double seconds(Work&& work)
{
  const double begin = onCore();
  work();
  return onCore() - begin;
}

enum class Memory
{
  Cold,
  Warm
};

enum class Stream
{
  Followed,
  SearchedAnew  ///< reset before each frame
};

/// Sum and contestant in turn. Cold: half a cycle apart, so that either finds a frame that the caches have lost. Warm:
/// several times each, so that either finds what it left there itself.
Timing measure(Candidate& candidate, const std::vector<Picture>& frames, Memory memory, Stream stream)
{
  const bool cold = memory == Memory::Cold;
  const int turn = cold ? 1 : kWarmTurn;
  std::vector<double> sums, owns;
  Stripe stripe;
  std::uint64_t kept = 0;
  const double begin = onCore();
  for (std::size_t round = 0; round < kMostRounds + 3; ++round)
  {
    const RawImage image = frames[cold ? round % frames.size() : 0].raw();
    const std::vector<std::uint8_t>& bytes = frames[cold ? (round + frames.size() / 2) % frames.size() : 0].bytes;
    const bool counts = round >= 3;  // the first warm up
    for (int i = 0; i < turn; ++i)
    {
      if (stream == Stream::SearchedAnew)
        candidate.reset();
      const double time = seconds([&] { candidate.process(image, stripe); });
      if (counts)
        owns.push_back(time);
    }
    for (int i = 0; i < turn; ++i)
    {
      const double time = seconds([&] { kept += simdSum(bytes.data(), bytes.size()); });
      if (counts)
        sums.push_back(time);
    }
    if (owns.size() >= kLeastRounds && onCore() - begin > kBudget)
      break;
  }
  if (kept == 0)  // never: but so the sums are not optimised away
    std::printf("black frames\n");
  return Timing{ quantile(sums, 0.5), quantile(owns, 0.5), quantile(owns, 0.25), quantile(owns, 0.75) };
}

std::unique_ptr<Candidate> timed(const std::string& name)
{
  CandidateSettings settings;
  settings.trace = false;
  return makeCandidate(name, settings);
}

/// One line of the table; the cold time of a stream that is followed.
Timing timeMethod(Context& context, const std::string& name, const std::vector<Picture>& frames)
{
  const std::unique_ptr<Candidate> candidate = timed(name);
  const Timing far = measure(*candidate, frames, Memory::Cold, Stream::Followed);
  const Timing anew = measure(*candidate, frames, Memory::Cold, Stream::SearchedAnew);
  const Timing near = measure(*candidate, frames, Memory::Warm, Stream::Followed);
  const Timing near_anew = measure(*candidate, frames, Memory::Warm, Stream::SearchedAnew);
  Report& report = context.report();
  report.row({ { "method", name },
               { "cold_us", 1e6 * far.own, 1 },
               { "ratio", far.ratio() },
               { "quartile", 1e6 * far.low, 1 },
               { "quartile3", 1e6 * far.high, 1 },
               { "anew_us", 1e6 * anew.own, 1 },
               { "anew_ratio", anew.ratio() },
               { "warm_us", 1e6 * near.own, 1 },
               { "warm_ratio", near.ratio() },
               { "warm_anew_us", 1e6 * near_anew.own, 1 },
               { "warm_anew_ratio", near_anew.ratio() },
               { "sum_cold_us", 1e6 * far.sum, 1 },
               { "sum_warm_us", 1e6 * near.sum, 1 } });
  if (name != context.judged())
    return far;
  const std::string anew_text = "searched anew: ";
  report.accept({ "default, time / SIMD sum, 1440x1080, warm", near.ratio(), 5.0, 3.0, false, "x",
                  anew_text + std::to_string(near_anew.ratio()).substr(0, 5) });
  report.accept({ "default, time / SIMD sum, 1440x1080, from memory", far.ratio(), 3.5, 2.0, false, "x",
                  anew_text + std::to_string(anew.ratio()).substr(0, 5) });
  return far;
}

/// Two contestants, and how many times faster the second is to be.
struct Pair
{
  const char *what, *slow, *fast;
  double bar, stretch;
};

void acceptFaster(Context& context, const std::map<std::string, Timing>& cold, const Pair& pair)
{
  const auto slow = cold.find(pair.slow), fast = cold.find(pair.fast);
  if (slow != cold.end() && fast != cold.end() && slow != fast)
    context.report().accept({ pair.what, slow->second.own / fast->second.own, pair.bar, pair.stretch, true, "x", "" });
}
}  // namespace

void compareTimes(Context& context)
{
  cv::setNumThreads(1);
  const std::vector<Picture> frames = framesOf({ 1440, 1080 });
  context.report().table("times", std::string("one frame of 1440x1080 mono8, one thread, medians [us]; ratio to one ") +
                                      simdSumPath() + " sum of a frame in the same loop; quartiles of the cold time");
  std::map<std::string, Timing> cold;
  for (const std::string& name : context.options().methods)
    cold[name] = timeMethod(context, name, frames);
  if (cold.count("svd") > 0)
    cold["svd_plain"] = timeMethod(context, "svd_plain", frames);
  if (cold.count("opencv_steger") > 0)
    cold["opencv_steger_in_band"] = timeMethod(context, "opencv_steger_in_band", frames);
  const std::string own = context.judged();
  acceptFaster(context, cold,
               { "default against plain OpenCV Steger on the frame, times faster", "opencv_steger", own.c_str(), 400.0,
                 1000.0 });
  acceptFaster(context, cold,
               { "default against plain OpenCV Steger in the same band, times faster", "opencv_steger_in_band",
                 own.c_str(), 5.0, 10.0 });
  acceptFaster(context, cold,
               { "  the same against the package's own steger in vectors", "steger", own.c_str(), 5.0, 10.0 });
  acceptFaster(context, cold, { "svd in its band against svd plain, times faster", "svd_plain", "svd", 25.0, 25.0 });
}

void compareSizes(Context& context)
{
  cv::setNumThreads(1);
  Report& report = context.report();
  report.table("sizes", "time from memory against the image's size: [us], and ratio to one SIMD sum of the frame");
  double first = 0.0, most = 0.0;
  for (const Size& size : { Size{ 640, 480 }, Size{ 1440, 1080 }, Size{ 2048, 1536 }, Size{ 4096, 3000 } })
  {
    const std::vector<Picture> frames = framesOf(size);
    for (const std::string& name : context.options().methods)
    {
      const Timing timing = measure(*timed(name), frames, Memory::Cold, Stream::Followed);
      report.row({ { "width", 1.0 * size.width, 0 },
                   { "height", 1.0 * size.height, 0 },
                   { "method", name },
                   { "cold_us", 1e6 * timing.own, 1 },
                   { "sum_us", 1e6 * timing.sum, 1 },
                   { "ratio", timing.ratio() } });
      if (name != context.judged())
        continue;
      (size.width == 640 ? first : most) = std::max(size.width == 640 ? 0.0 : most, timing.ratio());
    }
  }
  if (first > 0.0)
    report.accept({ "ratio to the SIMD sum from memory: largest of the larger sizes / that at 640x480", most / first,
                    1.0, 1.0, false, "x", "" });
}
}  // namespace comparison
}  // namespace weld_profiler
