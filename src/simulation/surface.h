#pragma once

#include <vector>

#include <Eigen/Core>

#include "simulation/ceilings.h"
#include "simulation/spots.h"

namespace weld_profiler
{
namespace simulation
{
/// The part's surface as a height field in the fixed frame. Immutable, thread safe.
class Surface
{
public:
  Surface(const Surface&) = delete;  // the spots know the bead by its address
  Surface& operator=(const Surface&) = delete;

  /// @param y_offset  fixed y of part y = 0.
  /// @param length    extent along y that is scanned [m].
  Surface(const SceneParams& scene, double y_offset, double length);

  double height(double x, double y) const;

  /// Slopes dz/dx, dz/dy of the piece of surface at (x, y); a block's walls do not count.
  Eigen::Vector2d slope(double x, double y) const;

  /// Scattering relative to the plates.
  double reflectance(double x, double y) const;

  TrueLabel label(double x, double y) const;

  /// What a grinder makes flush, and what it leaves of the bead. @param rest  left above the chord inside the bead.
  double target(double x, double y, double rest) const;

  /// Under a block.
  bool blocked(double x, double y) const { return blockAt(x, y - y_offset_) != nullptr; }

  /// In the fixed frame.
  std::vector<TrueSpot> spots() const;

  double highest() const { return highest_; }
  double lowest() const { return lowest_; }

  /// Distance along a ray at which it enters the surface, or a negative number if it gets away.
  /// @param direction  unit.
  /// @param step       of the search [m]; things thinner than it may be missed.
  double firstHit(const Eigen::Vector3d& from, const Eigen::Vector3d& direction, double step) const;

  const Bead& bead() const { return bead_; }
  double yOffset() const { return y_offset_; }

private:
  const SceneBlock* blockAt(double x, double part_y) const;
  double smooth(double x, double part_y, const SceneBlock* block) const;
  void findCeilings();
  void probe(double x, double part_y);

  Bead bead_;
  double bead_reflectance_;
  double y_offset_;
  std::vector<SceneBlock> blocks_;
  CellGrid grid_;  ///< of ceilings and spots, part coordinates
  Ceilings ceilings_, fine_ceilings_;
  Spots spots_;
  double highest_ = 0.0, lowest_ = 0.0;
};
}  // namespace simulation
}  // namespace weld_profiler
