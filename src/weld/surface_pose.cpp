#include "surface_pose.h"

namespace weld_profiler
{
namespace weld
{
SurfacePose poseAt(const PathFrame& frame, const PathPlace& place, double z, const HeightSample& slope)
{
  const Eigen::Vector2d spot = frame.at(place), along = frame.along(place.s);
  // the surface's tangents along and across the path; across = right of it
  const Eigen::Vector3d t(along.x(), along.y(), slope.along), r(along.y(), -along.x(), slope.across);
  Eigen::Matrix3d axes;
  axes.col(0) = t.normalized();
  axes.col(2) = r.cross(t).normalized();
  axes.col(1) = axes.col(2).cross(axes.col(0));
  SurfacePose pose;
  pose.position = { spot.x(), spot.y(), z };
  pose.orientation = Eigen::Quaterniond(axes).normalized();
  return pose;
}

SurfacePose reversed(const SurfacePose& pose)
{
  SurfacePose back = pose;
  back.orientation = pose.orientation * Eigen::Quaterniond(0.0, 0.0, 0.0, 1.0);
  return back;
}

SurfacePose lifted(const SurfacePose& pose, double height)
{
  SurfacePose above = pose;
  above.position += height * (pose.orientation * Eigen::Vector3d::UnitZ());
  return above;
}
}  // namespace weld
}  // namespace weld_profiler
