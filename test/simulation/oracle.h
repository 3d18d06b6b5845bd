#pragma once

#include <Eigen/Geometry>

#include "weld_profiler/geometry/calibration.h"

namespace weld_profiler
{
using Eigen::Vector2d;
using Eigen::Vector3d;

inline Vector3d vector(const std::array<double, 3>& values)
{
  return { values[0], values[1], values[2] };
}

// Written out here once more, from the definitions alone: p_camera = R p_scan + o - s a.
inline Vector3d toCamera(const Calibration& calibration, const Vector3d& scan, double stage)
{
  const Vector3d c(0.0, 0.0, 1.0);
  const Vector3d a = vector(calibration.stage.axis);
  const Vector3d n = vector(calibration.laser_plane.normal);
  const Vector3d z = -(c - c.dot(a) * a).normalized();
  const Vector3d o(0.0, 0.0, calibration.laser_plane.distance / n.z());
  return a.cross(z) * scan.x() + a * scan.y() + z * scan.z() + o - stage * a;
}

inline Vector2d project(const CameraCalibration& camera, const Vector3d& p)
{
  const double x = p.x() / p.z(), y = p.y() / p.z(), r = x * x + y * y;
  const auto& d = camera.distortion;
  const double radial = 1 + d[0] * r + d[1] * r * r + d[4] * r * r * r;
  return { camera.fx * (x * radial + 2 * d[2] * x * y + d[3] * (r + 2 * x * x)) + camera.cx - camera.roi_x,
           camera.fy * (y * radial + d[2] * (r + 2 * y * y) + 2 * d[3] * x * y) + camera.cy - camera.roi_y };
}
}  // namespace weld_profiler
