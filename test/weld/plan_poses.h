#pragma once

#include <Eigen/Geometry>

#include "made_weld.h"
#include "weld_profiler/weld/grinding.h"

namespace weld_profiler
{
inline Eigen::Vector3d axis(const SurfacePose& pose, int which)
{
  return pose.orientation.toRotationMatrix().col(which);
}

/// s and q of a pose on a made weld, s from its middle.
inline Eigen::Vector2d placeOf(const MadeWeld& weld, const SurfacePose& pose)
{
  return weld.locate(pose.position.x(), pose.position.y());
}
}  // namespace weld_profiler
