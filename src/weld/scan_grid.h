#pragma once

#include <algorithm>
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
/// moved and the camera looks. Rows without points are left out, and so are those that were seen while the stage stood
/// still, but for the first in y. A hole has z NaN; points filled in across a gap are holes.
struct ScanGrid
{
  int rows = 0;
  int cells = 0;
  double pitch = kNaN;        ///< median distance of neighbouring rows [m]; NaN with less than two rows
  double spacing = kNaN;      ///< median distance of neighbouring cells' points [m]; NaN without points
  bool mirrored = false;      ///< columns are the scan's cells in reverse
  std::vector<int> scan_row;  ///< of each row, its index in the scan
  std::vector<int> row_of;    ///< of each of the scan's rows, the row here that lies there; -1 = it has no points
  std::vector<double> row_y;  ///< of each row, median y [m]
  std::vector<float> x, y, z, sigma;

  /// Column of a scan's cell, and the other way round.
  int column(int cell) const { return mirrored ? cells - 1 - cell : cell; }

  std::size_t at(int row, int column) const
  {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(cells) + static_cast<std::size_t>(column);
  }

  /// Index of a point in the scan, row by row in the scan's own order.
  std::size_t inScan(int row, int column) const
  {
    return at(scan_row[static_cast<std::size_t>(row)], this->column(column));
  }
};

/// Where points of a grid lie, seen from above [m].
struct GridExtent
{
  static constexpr double kNone = std::numeric_limits<double>::infinity();
  double left = kNone, right = -kNone, near = kNone, far = -kNone;

  bool empty() const { return !(right >= left); }
  double width() const { return right - left; }
  double length() const { return far - near; }
};

/// @param use  whether the point of an index counts.
template <class Use>
GridExtent extentOf(const ScanGrid& grid, Use&& use)
{
  GridExtent extent;
  for (std::size_t i = 0; i < grid.z.size(); ++i)
  {
    if (!use(i))
      continue;
    const auto x = static_cast<double>(grid.x[i]), y = static_cast<double>(grid.y[i]);
    extent.left = std::min(extent.left, x), extent.right = std::max(extent.right, x);
    extent.near = std::min(extent.near, y), extent.far = std::max(extent.far, y);
  }
  return extent;
}

/// @throws PreconditionError when a cell lies outside the scan.
ScanGrid makeGrid(const Scan& scan);

/// A grid of one row. @throws PreconditionError when a cell lies outside the profile.
ScanGrid makeGrid(const Profile& profile);
}  // namespace weld
}  // namespace weld_profiler
