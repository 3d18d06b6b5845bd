#include "comparison/context.h"

#include <algorithm>
#include <cmath>

namespace weld_profiler
{
namespace comparison
{
namespace
{
constexpr std::size_t kEnough = 30;  ///< centres that an RMS is worth telling of

double worse(double a, double b)
{
  const auto distance = [](double x) { return std::isfinite(x) && x > 0.0 ? std::abs(std::log(x)) : -1.0; };
  return distance(a) >= distance(b) ? a : b;
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

void Context::reportHonesty()
{
  if (honesty_.empty())
    return;
  report_.table("honesty", "RMS of error over told sigma, 1 = honest: the scenes farthest from 1 (points within 1 px)");
  for (const std::string& method : options_.methods)
  {
    double least = INFINITY, most = 0.0, interpolated = std::nan("");
    std::string least_scene, most_scene, interpolated_scene;
    for (const Honesty& line : honesty_)
    {
      if (line.method != method)
        continue;
      report_.row({ { "method", method },
                    { "scene", line.scene },
                    { "measured", line.measured, 3 },
                    { "interpolated", line.interpolated, 3 } },
                  Report::Silent);
      if (line.measured < least)
      {
        least = line.measured;
        least_scene = line.scene;
      }
      if (line.measured > most)
      {
        most = line.measured;
        most_scene = line.scene;
      }
      if (std::isfinite(line.interpolated) && worse(line.interpolated, interpolated) == line.interpolated)
      {
        interpolated = line.interpolated;
        interpolated_scene = line.scene;
      }
    }
    if (!(most > 0.0))
      continue;
    report_.row({ { "method", method },
                  { "least", least },
                  { "most", most },
                  { "interp.", interpolated },
                  { "scenes", least_scene + " / " + most_scene + " / " + interpolated_scene } });
    if (method != defaultMethod())
      continue;
    const double factor = std::max(most, 1.0 / least);
    report_.accept({ "error / sigma, measured points, farthest from 1 in any scene (factor)", factor, 1.25, 1.25, false,
                     "x", factor == most ? most_scene : least_scene });
    if (std::isfinite(interpolated))
      report_.accept({ "error / sigma, interpolated points, farthest from 1 in any scene (factor)",
                       std::max(interpolated, 1.0 / interpolated), 1.25, 1.25, false, "x", interpolated_scene });
  }
}
}  // namespace comparison
}  // namespace weld_profiler
