// How well scans before and after grinding are compared: simulated welds through the whole chain, against their exact
// truth. docs/compare.md says what is compared and shows the table.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "tools/command_line.h"
#include "weld/ground_case.h"
#include "weld/ground_weld.h"
#include "weld_profiler/core/errors.h"
#include "weld_profiler/weld/scan_comparison.h"

namespace weld_profiler
{
namespace weld_accuracy
{
namespace
{
constexpr double kCubicMm = 1e9;
constexpr double kLeastVolume = 1e-9;  // of less no share is told: it was ground flush [m^3]

struct Options
{
  int welds = 36;
  int first = 1;
};

/// What became of one volume, over all welds.
class Tally
{
public:
  void add(const Quantity& told, double truth, const GroundCase& weld)
  {
    const double error = told.value - truth;
    errors_.push_back(kCubicMm * std::abs(error));
    if (truth > kLeastVolume)
      shares_.push_back(100.0 * std::abs(error) / truth);
    squares_ += std::pow(error / told.sigma, 2.0);
    worst_ = std::max(worst_, std::abs(error / told.sigma));
    good_ += std::abs(error) <= std::max(0.01 * truth, 5e-6 * weld.width() * weld.length()) ? 1 : 0;
  }

  void print(const char* what)
  {
    std::sort(errors_.begin(), errors_.end());
    std::sort(shares_.begin(), shares_.end());
    const std::size_t middle = errors_.size() / 2;
    const double share = shares_.empty() ? NAN : shares_[shares_.size() / 2];
    const double worst = shares_.empty() ? NAN : shares_.back();
    std::printf(
        "  %-9s error median %.3f largest %.3f mm^3 (%.2f, %.2f %%), within max(1 %%, 5 um b L): %d of %zu, "
        "error / sigma: RMS %.2f largest %.2f\n",
        what, errors_[middle], errors_.back(), share, worst, good_, errors_.size(),
        std::sqrt(squares_ / static_cast<double>(errors_.size())), worst_);
  }

private:
  std::vector<double> errors_, shares_;
  double squares_ = 0.0, worst_ = 0.0;
  int good_ = 0;
};

/// One placement of the part.
struct Placement
{
  const char* name;
  Eigen::Isometry3d motion;
  Tally removed, remaining;
  std::size_t spots = 0;
  double residual = 0.0, milliseconds = 0.0;
};

void compare(const GroundCase& weld, std::uint64_t seed, Placement& placement)
{
  const Scan after = moved(weld.after, placement.motion);
  const auto begin = std::chrono::steady_clock::now();
  const ScanComparison comparison = ScanComparer().compare(weld.before, after);
  placement.milliseconds += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
  placement.removed.add(comparison.removed_volume, weld.removed, weld);
  placement.remaining.add(comparison.remaining_volume, weld.remaining, weld);
  placement.spots += comparison.over_ground.size();
  placement.residual = std::max(placement.residual, comparison.aligned.residual);
  const Quantity &removed = comparison.removed_volume, &remaining = comparison.remaining_volume;
  std::printf(
      "%3llu %-13s %-18s b %5.2f h %.2f to %.2f mm, removed %8.3f (true %8.3f, sigma %.3f), remaining %8.3f "
      "(true %8.3f, sigma %.3f) mm^3%s\n",
      static_cast<unsigned long long>(seed), weld.scene().weld.kind.c_str(), placement.name, 1e3 * weld.width(),
      1e3 * weld.scene().weld.reinforcement, 1e3 * weld.rest(), kCubicMm * removed.value, kCubicMm * weld.removed,
      kCubicMm * removed.sigma, kCubicMm * remaining.value, kCubicMm * weld.remaining, kCubicMm * remaining.sigma,
      comparison.aligned.across_told ? "" : ", shift across not told");
  std::fflush(stdout);
}

/// Flush, at most 0.2 mm left, half left: they take turns every three seeds, as kinds do every seed.
double restOf(std::uint64_t seed)
{
  constexpr double kRests[] = { 0.0, 2e-4, -0.5 };
  return kRests[seed / 3 % 3];
}

/// How many could be compared: some of the random welds are too low to be told.
std::uint64_t compareAll(std::uint64_t first, std::uint64_t welds, std::vector<Placement>& placements)
{
  std::uint64_t compared = 0;
  for (std::uint64_t seed = first; seed < first + welds; ++seed)
  {
    const GroundCase weld(seed, restOf(seed));
    try
    {
      for (Placement& placement : placements)
        compare(weld, seed, placement);
      ++compared;
    }
    catch (const InputError& error)
    {
      std::printf("%3llu %-13s skipped: %s\n", static_cast<unsigned long long>(seed), weld.scene().weld.kind.c_str(),
                  error.what());
    }
  }
  return compared;
}

void runAll(const Options& options)
{
  std::vector<Placement> placements;
  placements.push_back({ "as it lies", Eigen::Isometry3d::Identity(), {}, {} });
  placements.push_back(
      { "shifted and turned", motionAbout({ 0.0, 0.01, 0.0 }, { 3e-4, -4e-4, 1.2e-3 }, { 1.0, -0.8, 0.3 }), {}, {} });
  const auto first = static_cast<std::uint64_t>(options.first), welds = static_cast<std::uint64_t>(options.welds);
  const std::uint64_t compared = compareAll(first, welds, placements);
  std::printf("%llu of %llu welds compared, %llu skipped\n", static_cast<unsigned long long>(compared),
              static_cast<unsigned long long>(welds), static_cast<unsigned long long>(welds - compared));
  if (compared == 0)
    return;
  for (Placement& placement : placements)
  {
    std::printf("%s: over-ground places, none true: %zu; parents apart at most %.2f um; %.0f ms each\n", placement.name,
                placement.spots, 1e6 * placement.residual, placement.milliseconds / static_cast<double>(compared));
    placement.removed.print("removed");
    placement.remaining.print("remaining");
  }
}

int run(int argc, char** argv)
{
  Options options;
  CommandLine command(
      "compare_accuracy",
      "Compares simulated welds before and after grinding with the truth: removed and remaining volume,\n"
      "as the part lies and after it was put back elsewhere.");
  command.option("welds N", options.welds, "how many");
  command.option("first SEED", options.first, "seed of the first, the others follow it; kinds take turns");
  command.example("compare_accuracy --welds 9");
  if (!command.parse(argc, argv))
    return 0;
  if (options.welds < 1 || options.first < 0)
    throw UsageError("--welds must be 1 or more and --first 0 or more");
  runAll(options);
  return 0;
}
}  // namespace
}  // namespace weld_accuracy
}  // namespace weld_profiler

int main(int argc, char** argv)
{
  try
  {
    return weld_profiler::weld_accuracy::run(argc, argv);
  }
  catch (const weld_profiler::UsageError& error)
  {
    std::fprintf(stderr, "compare_accuracy: %s\n", error.what());
    return 2;
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "compare_accuracy: %s\n", error.what());
    return 1;
  }
}
