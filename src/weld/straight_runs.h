#pragma once

#include <vector>

#include "line.h"
#include "scan_grid.h"

namespace weld_profiler
{
namespace weld
{
/// Mean point of a few neighbouring cells of a row.
struct Node
{
  double x = 0.0, z = 0.0;
  int cell = 0;  ///< the first of its cells
};

/// A straight piece of a row: nodes from first up to, not including, end.
struct StraightRun
{
  int first = 0, end = 0;
  double x_from = 0.0, x_to = 0.0;
  Line line;
  bool bare = false;  ///< a short piece of a plate, most of which lies elsewhere in the row

  double length() const { return x_to - x_from; }
};

/// The nodes of a row, about 0.3 mm apart.
std::vector<Node> rowNodes(const ScanGrid& grid, int row);

/// Scatter of neighbouring nodes about straight lines [m].
double nodeNoise(const std::vector<Node>& nodes);

/// Cuts a row's outline into straight pieces by merging neighbours, the straightest first, as long as the merged one's
/// scatter stays below tolerance. Source: bottom-up segmentation, E. Keogh et al., "An Online Algorithm for Segmenting
/// Time Series", Proc. IEEE ICDM 2001.
std::vector<StraightRun> straightRuns(const std::vector<Node>& nodes, double tolerance);
}  // namespace weld
}  // namespace weld_profiler
