#include "comparison/context.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace weld_profiler
{
namespace comparison
{
namespace
{
constexpr std::size_t kEnough = 30;  ///< centres that an RMS is worth telling of

/// As a factor, above 1 on either side; NaN stays NaN.
double farFromOne(double ratio)
{
  return ratio < 1.0 ? 1.0 / ratio : ratio;
}
}  // namespace

bool Context::wants(const std::string& part) const
{
  return options_.only.empty() || std::find(options_.only.begin(), options_.only.end(), part) != options_.only.end();
}

void Context::noteHonesty(const std::string& scene, const std::string& method, const Score& score)
{
  const auto told = [](const ErrorSums& sums) { return sums.with_sigma >= kEnough ? sums.honesty() : std::nan(""); };
  honesty_.push_back(Honesty{ scene, method, told(score.measured), told(score.interpolated) });
}

/// Prints the extremes of one method; every scene goes to the file.
void Context::reportHonestyOf(const std::string& method)
{
  const Honesty none{ "", method, std::nan(""), std::nan("") };
  Honesty least = none, most = none, filled = none;
  for (const Honesty& line : honesty_)
  {
    if (line.method != method)
      continue;
    report_.row({ { "method", method },
                  { "scene", line.scene },
                  { "measured", line.measured, 3 },
                  { "interpolated", line.interpolated, 3 } },
                Report::Silent);
    if (!(line.measured >= least.measured))
      least = std::isfinite(line.measured) ? line : least;
    if (!(line.measured <= most.measured))
      most = std::isfinite(line.measured) ? line : most;
    if (!(farFromOne(line.interpolated) <= farFromOne(filled.interpolated)))
      filled = std::isfinite(line.interpolated) ? line : filled;
  }
  if (least.scene.empty())
    return;
  report_.row({ { "method", method },
                { "least", least.measured },
                { "most", most.measured },
                { "interp.", filled.interpolated },
                { "scenes", least.scene + " / " + most.scene + " / " + filled.scene } });
  if (method != judged())
    return;
  const Honesty& worst = farFromOne(least.measured) > farFromOne(most.measured) ? least : most;
  char told[160];
  std::snprintf(told, sizeof told, "%.2f in %s; all scenes %.2f to %.2f", worst.measured, worst.scene.c_str(),
                least.measured, most.measured);
  report_.accept({ "error / sigma, measured points, farthest from 1 in any scene (factor)", farFromOne(worst.measured),
                   1.25, 1.25, false, "x", told });
  if (filled.scene.empty())
    return;
  std::snprintf(told, sizeof told, "%.2f in %s", filled.interpolated, filled.scene.c_str());
  report_.accept({ "error / sigma, interpolated points, farthest from 1 in any scene (factor)",
                   farFromOne(filled.interpolated), 1.25, 1.25, false, "x", told });
}

void Context::reportHonesty()
{
  if (honesty_.empty())
    return;
  report_.table("honesty", "RMS of error over told sigma, 1 = honest: the scenes farthest from 1 (points within 1 px)");
  for (const std::string& method : options_.methods)
    reportHonestyOf(method);
}
}  // namespace comparison
}  // namespace weld_profiler
