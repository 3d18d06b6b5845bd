#pragma once

#include <cmath>
#include <random>

#include <Eigen/Core>

#include "weld_profiler/geometry/calibration.h"

inline Eigen::Vector3d axisOf(const weld_profiler::Calibration& rig)
{
  return Eigen::Map<const Eigen::Vector3d>(rig.stage.axis.data());
}

inline Eigen::Vector3d normalOf(const weld_profiler::Calibration& rig)
{
  return Eigen::Map<const Eigen::Vector3d>(rig.laser_plane.normal.data());
}

/// A rig that a calibration file may describe: any laser plane that the optical axis meets 0.1 to 0.6 m before the
/// camera, any stage axis at least 15 deg off the plane and the optical axis, a distorting lens.
inline weld_profiler::Calibration randomRig(std::mt19937& generator)
{
  std::normal_distribution<double> gauss(0.0, 1.0);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const auto direction = [&]
  { return Eigen::Vector3d(gauss(generator), gauss(generator), gauss(generator)).normalized(); };
  Eigen::Vector3d normal = direction();
  Eigen::Vector3d axis = direction();
  while (std::abs(normal.z()) < 0.3 || std::abs(normal.dot(axis)) < 0.26 || std::abs(axis.z()) > 0.96)
  {
    normal = direction();
    axis = direction();
  }
  weld_profiler::Calibration rig;
  rig.laser_plane.normal = { { normal.x(), normal.y(), normal.z() } };
  rig.laser_plane.distance = (0.1 + 0.5 * uniform(generator)) * normal.z();
  rig.stage.axis = { { axis.x(), axis.y(), axis.z() } };
  rig.camera.fx = 2500.0 + 4000.0 * uniform(generator);
  rig.camera.fy = rig.camera.fx * 1.003;
  rig.camera.cx = 700.0 + 40.0 * uniform(generator);
  rig.camera.cy = 520.0 + 40.0 * uniform(generator);
  rig.camera.distortion = { { -0.2 * uniform(generator), 0.1, 1e-3, -2e-3, 0.05 } };
  return rig;
}
