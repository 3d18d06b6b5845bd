#pragma once

#include <cstddef>

namespace weld_profiler
{
namespace simulation
{
/// Squares over part coordinates.
struct CellGrid
{
  double x = 0.0, y = 0.0;  ///< first corner
  double cell = 0.001;      ///< side of a square [m]
  int columns = 0, rows = 0;
  double scanned = 0.0;  ///< length of the scan along y [m]

  std::size_t size() const { return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows); }
  std::size_t at(int column, int row) const
  {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
  }
  /// -1 outside.
  int index(double at_x, double at_y) const
  {
    const double column = (at_x - x) / cell;
    const double row = (at_y - y) / cell;
    if (!(column >= 0.0 && column < columns && row >= 0.0 && row < rows))
      return -1;
    return static_cast<int>(row) * columns + static_cast<int>(column);
  }
};
}  // namespace simulation
}  // namespace weld_profiler
