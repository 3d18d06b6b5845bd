#pragma once

#include <vector>

#include "row_beads.h"

namespace weld_profiler
{
namespace weld
{
/// One bead through the rows: at most one finding a row, rising rows.
struct BeadTrack
{
  std::vector<RowBead> rows;
  double strength = 0.0;  ///< sum of the areas; of rows that show one parent a part of it

  double width() const;   ///< median [m]
  double height() const;  ///< median [m]
};

/// Joins what neighbouring rows show at the same place, the strongest first. Tracks seen in less than min_rows are
/// left out.
std::vector<BeadTrack> trackBeads(const ScanGrid& grid, const std::vector<RowFindings>& findings, int min_rows);
}  // namespace weld
}  // namespace weld_profiler
