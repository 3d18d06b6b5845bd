#pragma once

#include <vector>

#include "simulation/rig.h"
#include "simulation/surface.h"

namespace weld_profiler
{
namespace simulation
{
/// Pixels along the stripe (cell) and across it (across): u, v for a stripe along the rows, else v, u.
struct StripePixel
{
  double cell = 0.0;
  double across = 0.0;
};

/// One point of the line in which the laser sheet cuts the surface.
struct CutPoint
{
  double t = 0.0;                                      ///< parameter along the sheet [m]
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< fixed frame
  StripePixel pixel;
  bool lit = false;     ///< the laser reaches it
  bool seen = false;    ///< the camera sees it
  bool joined = false;  ///< the surface runs on to the next point without a wall
};

/// The laser sheet of one moment, cut with the surface.
class SheetCut
{
public:
  /// @param cells   pixels along the stripe.
  /// @param across  pixels across it.
  SheetCut(const Surface& surface, const Rig& rig, const RigPose& pose);

  /// Points about half a pixel apart, in rising cells, from before the first cell to after the last.
  std::vector<CutPoint> trace() const;

  /// Where the sheet meets the surface at t; false where it slips between (the edge of a wall).
  /// @param point  its height on entry is where the search begins.
  bool at(double t, CutPoint& point) const;

  StripePixel project(const Eigen::Vector3d& fixed) const;
  Eigen::Vector2d raw(const StripePixel& pixel) const;
  int cells() const { return cells_; }
  int acrossPixels() const { return across_pixels_; }
  const RigPose& pose() const { return pose_; }
  const Surface& surface() const { return surface_; }

private:
  double range(const Eigen::Vector2d& pixel, double z) const;
  void light(std::vector<CutPoint>& points) const;
  void look(std::vector<CutPoint>& points) const;

  const Surface& surface_;
  const Rig& rig_;
  RigPose pose_;
  bool swapped_;  ///< the stripe runs along v
  int cells_, across_pixels_;
  Eigen::Vector3d along_;  ///< horizontal direction in the sheet
  Eigen::Vector3d ahead_;  ///< horizontal, across the sheet
  double first_t_ = 0.0, last_t_ = 0.0;
};
}  // namespace simulation
}  // namespace weld_profiler
