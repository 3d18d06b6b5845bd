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

/// What a place beside the path shows.
enum class Zone
{
  Plate,
  Bead,
  Undercut
};

/// Plates and bead as a height over part coordinates, without blocks, spatter and pores.
class Bead
{
public:
  Bead(const ScenePlates& plates, const SceneWeld& weld, const SceneSecondBead& second);

  /// @param x,y  part coordinates [m].
  PathPoint locate(double x, double y) const;

  /// Part coordinates of a point beside the path; the inverse of locate().
  Eigen::Vector2d place(const PathPoint& point) const;

  /// Direction of travel of the path against +y, from +y toward -x [rad].
  double heading(double s) const;

  double plateHeight(const PathPoint& point) const;
  double height(const PathPoint& point) const;

  /// What a grinder makes flush: the chord of the toes and a rest above it, along its normal,
  /// inside the bead, the plates outside.
  double target(const PathPoint& point, double rest) const;

  /// An undercut is where the surface lies more than kUndercut below the plate.
  Zone zone(const PathPoint& point) const;
  static constexpr double kUndercut = 2e-5;  ///< [m]

  /// Slope of the steeper plate, >= 0.
  double steepest() const;

  /// Half the bead's width at s; 0 outside the weld.
  double halfWidth(double s) const;

  /// Full width and height are reached at s: no end of a bead is near.
  bool risen(double s) const { return rise(run(s)) == 1.0; }

  const SceneWeld& weld() const { return weld_; }

private:
  /// How far it is to the ends of the bead (of several: the one at s); negative outside.
  struct Run
  {
    double from_start, to_end;
  };

  Run run(double s) const;
  double rise(const Run& run) const;
  double crater(const Run& run) const;
  double chord(const PathPoint& point, double half) const;
  double face(const PathPoint& point, double half) const;
  double undercut(const PathPoint& point, double outside) const;
  double ground(const PathPoint& point) const;

  ScenePlates plates_;
  SceneWeld weld_;
  SceneSecondBead second_;
  double warp_;                      ///< moves the crest: u - warp (1 - u^2) is 0 there, u the share of half the width
  double slope_left_, slope_right_;  ///< of the plates, outward
  Eigen::Vector2d middle_, tangent_, right_;
};
}  // namespace simulation
}  // namespace weld_profiler
