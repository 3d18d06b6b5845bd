#include "simulation/ceilings.h"

#include <algorithm>
#include <limits>

namespace weld_profiler
{
namespace simulation
{
Ceilings::Ceilings(const CellGrid& grid) : grid_(grid), tops_(grid.size(), -std::numeric_limits<float>::infinity()) {}

void Ceilings::raise(double x, double y, double z)
{
  const int cell = grid_.index(x, y);
  if (cell < 0)
    return;
  float& top = tops_[static_cast<std::size_t>(cell)];
  top = std::max(top, static_cast<float>(z));
}

void Ceilings::widen()
{
  const std::vector<float> own = tops_;
  for (int row = 0; row < grid_.rows; ++row)
    for (int column = 0; column < grid_.columns; ++column)
      for (int y = std::max(0, row - 1); y <= std::min(grid_.rows - 1, row + 1); ++y)
        for (int x = std::max(0, column - 1); x <= std::min(grid_.columns - 1, column + 1); ++x)
        {
          float& top = tops_[grid_.at(column, row)];
          top = std::max(top, own[grid_.at(x, y)]);
        }
}
}  // namespace simulation
}  // namespace weld_profiler
