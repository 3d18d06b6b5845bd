#pragma once

#include <Eigen/Core>

#include "weld_profiler/simulation/scene_params.h"

namespace weld_profiler
{
namespace simulation
{
/// Where a point lies relative to the weld's path: q to the right of it, s along it from its first end.
struct PathPoint
{
  double q = 0.0;
  double s = 0.0;
};

/// Plates and bead as a height over part coordinates, without blocks and spatter.
class Bead
{
public:
  Bead(const ScenePlates& plates, const SceneWeld& weld);

  /// @param x,y  part coordinates [m].
  PathPoint locate(double x, double y) const;

  /// Part coordinates of a point beside the path; the inverse of locate().
  Eigen::Vector2d place(const PathPoint& point) const;

  /// Direction of travel of the path against +y, from +y toward -x [rad].
  double heading(double s) const;

  double plateHeight(const PathPoint& point) const;
  double height(const PathPoint& point) const;

  /// Half the bead's width at s; 0 outside the weld.
  double halfWidth(double s) const;

private:
  double rise(double s) const;
  double face(const PathPoint& point, double half) const;
  double undercut(const PathPoint& point, double outside) const;

  ScenePlates plates_;
  SceneWeld weld_;
  double slope_;  ///< of each plate
  Eigen::Vector2d middle_, tangent_, right_;
};
}  // namespace simulation
}  // namespace weld_profiler
