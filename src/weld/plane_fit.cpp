#include "plane_fit.h"

#include <algorithm>

#include <Eigen/Dense>

#include "statistics.h"

namespace weld_profiler
{
namespace weld
{
Plane fitPlane(const std::vector<Eigen::Vector3d>& points)
{
  constexpr int kSteps = 12;
  constexpr double kFloor = 1e-6;   // of the scatter [m]
  constexpr double kLevel = 1e-12;  // keeps the slope that nothing tells at zero [m^2]
  Plane plane;
  if (points.empty())
    return plane;
  for (const Eigen::Vector3d& point : points)
    plane.origin += point / static_cast<double>(points.size());
  std::vector<double> weights(points.size(), 1.0), residuals(points.size());
  for (int step = 0; step < kSteps; ++step)
  {
    Eigen::Matrix3d normal = kLevel * Eigen::Matrix3d::Identity();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const Eigen::Vector3d from = points[i] - plane.origin, basis(1.0, from.x(), from.y());
      normal += weights[i] * basis * basis.transpose();
      right += weights[i] * basis * from.z();
    }
    const Eigen::Vector3d fitted = normal.ldlt().solve(right);
    plane.height = fitted.x();
    plane.slope = fitted.tail<2>();
    for (std::size_t i = 0; i < points.size(); ++i)
      residuals[i] = points[i].z() - plane.at(points[i].x(), points[i].y());
    plane.scatter = std::max(kFloor, robustSigma(residuals));
    for (std::size_t i = 0; i < points.size(); ++i)
      weights[i] = tukey(residuals[i] / plane.scatter);
  }
  return plane;
}
}  // namespace weld
}  // namespace weld_profiler
