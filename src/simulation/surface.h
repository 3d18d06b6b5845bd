#pragma once

#include <vector>

#include <Eigen/Core>

#include "simulation/bead.h"

namespace weld_profiler
{
namespace simulation
{
/// The part's surface as a height field in the fixed frame. Immutable, thread safe.
class Surface
{
public:
  /// @param y_offset  fixed y of part y = 0.
  /// @param length    extent along y that is scanned [m].
  Surface(const SceneParams& scene, double y_offset, double length);

  double height(double x, double y) const;

  /// Slopes dz/dx, dz/dy of the piece of surface at (x, y); a block's walls do not count.
  Eigen::Vector2d slope(double x, double y) const;

  /// Scattering relative to the plates.
  double reflectance(double x, double y) const;

  /// No point of the surface within a millimetre around (x, y) is higher.
  double ceiling(double x, double y) const;
  double highest() const { return highest_; }
  double lowest() const { return lowest_; }

  /// Distance along a ray at which it enters the surface, or a negative number if it gets away.
  /// @param direction  unit.
  /// @param step       of the search [m]; things thinner than it may be missed.
  double firstHit(const Eigen::Vector3d& from, const Eigen::Vector3d& direction, double step) const;

  const Bead& bead() const { return bead_; }
  double yOffset() const { return y_offset_; }

private:
  struct Ball
  {
    double x, y, z, radius;
  };

  const SceneBlock* blockAt(double x, double part_y) const;
  double smooth(double x, double part_y, const SceneBlock* block) const;
  void placeBalls(const SceneParams& scene, double length);
  void findCeilings();
  void probe(double x, double part_y);
  void widenCeilings();
  int cellIndex(double x, double part_y) const;
  std::size_t cellAt(int column, int row) const
  {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  }

  Bead bead_;
  double bead_reflectance_;
  double y_offset_;
  std::vector<SceneBlock> blocks_;
  std::vector<std::vector<Ball>> buckets_;
  std::vector<float> ceilings_;
  double grid_x_ = 0.0, grid_y_ = 0.0;  ///< first corner of the grid of ceilings and buckets, part coordinates
  int columns_ = 0, rows_ = 0;
  double highest_ = 0.0, lowest_ = 0.0;
};
}  // namespace simulation
}  // namespace weld_profiler
