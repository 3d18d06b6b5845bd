#pragma once

#include <vector>

#include <Eigen/Core>

namespace weld_profiler
{
namespace weld
{
/// A plane in the scan frame: z over x and y.
struct Plane
{
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< mean of the points it was fitted to, not quite in it
  double height = 0.0;                               ///< of the plane over `origin`
  Eigen::Vector2d slope = Eigen::Vector2d::Zero();   ///< dz/dx, dz/dy
  double scatter = 0.0;                              ///< of the points about it, robustly [m]

  double at(double x, double y) const
  {
    return origin.z() + height + slope.x() * (x - origin.x()) + slope.y() * (y - origin.y());
  }
};

/// The plane that most points lie in (Tukey's biweight, begun at least squares). A direction that the points tell no
/// slope of has none: a single row along x is level along y. Without points: z = 0. The scatter is no less than 1 um.
Plane fitPlane(const std::vector<Eigen::Vector3d>& points);
}  // namespace weld
}  // namespace weld_profiler
