#pragma once

#include <vector>

#include <Eigen/Core>

#include "weld_path.h"
#include "weld_profiler/weld/weld_result.h"

namespace weld_profiler
{
namespace weld
{
/// Coordinates along and across a measured weld, seen from above: s along its path, q to the right of it. The path goes
/// through the points of the result, smoothly; straight on beyond its ends. Immutable, thread safe.
class PathFrame
{
public:
  /// @throws PreconditionError with less than two points, one that is not finite, or an s that does not rise.
  explicit PathFrame(const std::vector<WeldPathPoint>& path);

  Eigen::Vector2d at(const PathPlace& place) const;

  /// Direction of travel at s, of length 1.
  Eigen::Vector2d along(double s) const;

  /// @param near_s  a guess; a few steps of Newton's method lead from it to the place.
  PathPlace locate(double x, double y, double near_s) const;

private:
  struct Station
  {
    double s = 0.0;
    Eigen::Vector2d place, along;
  };
  struct Spot
  {
    Eigen::Vector2d place, along;
  };
  Spot spot(double s) const;

  std::vector<Station> stations_;  ///< rising s
};
}  // namespace weld
}  // namespace weld_profiler
