#pragma once

#include <vector>

#include "simulation/cell_grid.h"

namespace weld_profiler
{
namespace simulation
{
/// How high the surface reaches around a place, by cells of a grid.
class Ceilings
{
public:
  explicit Ceilings(const CellGrid& grid);

  /// Told of a point of the surface.
  void raise(double x, double y, double z);

  /// Each cell takes the highest of its neighbours, so that a ray above it is clear for a whole cell around.
  void widen();

  /// No point of the surface within a cell around (x, y) is higher. @param outside  what is told beyond the grid.
  double at(double x, double y, double outside) const
  {
    const int cell = grid_.index(x, y);
    return cell < 0 ? outside : static_cast<double>(tops_[static_cast<std::size_t>(cell)]);
  }

  double cell() const { return grid_.cell; }

private:
  CellGrid grid_;
  std::vector<float> tops_;
};
}  // namespace simulation
}  // namespace weld_profiler
