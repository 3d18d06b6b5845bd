#pragma once

#include <vector>

#include "line.h"
#include "scan_grid.h"
#include "weld_profiler/weld/weld_params.h"

namespace weld_profiler
{
namespace weld
{
/// What looks like a bead in one row, roughly.
struct RowBead
{
  int row = 0;
  double x_left = 0.0, x_right = 0.0;  ///< toes [m]
  double height = 0.0;                 ///< above chord, or in a corner above the parents [m]
  double area = 0.0;                   ///< likewise [m^2]
  Line left, right;                    ///< parents, z over x; invalid = not in view
  bool whole() const { return left.valid() && right.valid(); }
};

/// What a row shows.
struct RowFindings
{
  std::vector<RowBead> beads;
  bool straight = false;  ///< it shows at least one straight piece long enough to be a parent
  bool sunken = false;    ///< a piece between two parents lies below both: a groove, or a scan upside down
  bool block = false;     ///< something stands on a parent with an upright wall on either side
};

/// Finds beads in a row: straight pieces are parents, unless they lie above both of their neighbours (a flat face);
/// what rises between two parents is a bead, unless it has upright walls.
RowFindings findRowBeads(const ScanGrid& grid, int row, const WeldParams& params);
}  // namespace weld
}  // namespace weld_profiler
