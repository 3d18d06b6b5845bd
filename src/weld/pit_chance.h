#pragma once

#include <cstddef>
#include <vector>

#include "scan_grid.h"

namespace weld_profiler
{
namespace weld
{
/// How large pits a scan's own outliers make. Those that are too small to be told, or lie in one row, nothing else need
/// have made; the larger, the rarer, by a factor of e with every so many points as these have in the mean.
class PitChance
{
public:
  /// @param grid  must outlive it.  @param fewest  points of a pit that is told.
  PitChance(const ScanGrid& grid, std::size_t fewest) : grid_(grid), fewest_(fewest) {}

  /// Every pit of the face has to be looked at, before one is judged.
  void look(const std::vector<std::size_t>& pit);

  /// Whether outliers may have made a pit. A row is no more than one of them, however wide.
  bool mayMake(const std::vector<std::size_t>& pit) const;

private:
  /// Whether a pit lies in one row.
  bool inOneRow(const std::vector<std::size_t>& pit) const;

  const ScanGrid& grid_;
  std::size_t fewest_;
  // one of two points is taken to be in every scan: that none was seen does not show that there are none
  double count_ = 1.0, points_ = 2.0;
};
}  // namespace weld
}  // namespace weld_profiler
