#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "weld_profiler/core/scan.h"

namespace weld_profiler
{
namespace weld
{
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// The measured points of a scan as arrays, rows x columns. Rows rise in y and columns in x, whichever way the stage
/// moved and the camera looks; rows without points are left out. A hole has z NaN; points filled in across a gap are
/// holes.
struct ScanGrid
{
  int rows = 0;
  int cells = 0;
  double pitch = kNaN;        ///< median distance of neighbouring rows [m]; NaN with less than two rows
  double spacing = kNaN;      ///< median distance of neighbouring cells' points [m]; NaN without points
  bool mirrored = false;      ///< columns are the scan's cells in reverse
  std::vector<int> scan_row;  ///< of each row, its index in the scan
  std::vector<double> row_y;  ///< of each row, median y [m]
  std::vector<float> x, y, z, sigma;

  /// Column of a scan's cell, and the other way round.
  int column(int cell) const { return mirrored ? cells - 1 - cell : cell; }

  std::size_t at(int row, int column) const
  {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(cells) + static_cast<std::size_t>(column);
  }
};

/// @throws PreconditionError when a cell lies outside the scan.
ScanGrid makeGrid(const Scan& scan);

/// A grid of one row. @throws PreconditionError when a cell lies outside the profile.
ScanGrid makeGrid(const Profile& profile);
}  // namespace weld
}  // namespace weld_profiler
