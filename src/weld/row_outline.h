#pragma once

#include <vector>

#include "row_beads.h"
#include "straight_runs.h"

namespace weld_profiler
{
namespace weld
{
/// A row's outline as nodes, and what is asked of it about a bead.
class RowOutline
{
public:
  RowOutline(const ScanGrid& grid, int row);

  const std::vector<Node>& nodes() const { return nodes_; }
  const Node& node(int i) const { return nodes_[static_cast<std::size_t>(i)]; }
  int size() const { return static_cast<int>(nodes_.size()); }
  double noise() const { return noise_; }  ///< scatter of a node [m]
  double seen() const { return seen_; }    ///< a node farther off a line stands out from it [m]

  /// First node from `from` on (up or down to, not including, `end`) from where the outline stays off the line for
  /// at least `width`: spatter does not; `end` if none.
  int firstOff(int from, int end, const Line& line, double width) const;

  /// The node that rises highest above a bead's reference.
  int highest(int first, int last, const RowBead& bead) const;

  /// The last node, from the bead's top outward to `end`, before the outline stays on its parent: what stands farther
  /// out (spatter) is not the bead's.
  int footOf(int top, int end, const Line& line, const RowBead& bead) const;

  /// Toes between the first and last node of a bead and their neighbours.
  void setToes(int first, int last, RowBead& bead) const;

  /// Sums height and area; returns the share of nodes above the reference.
  double sumUp(int first, int last, RowBead& bead) const;

  /// An upright wall at x: the outline jumps from one measured cell to the next.
  bool wall(double x) const;

private:
  const ScanGrid& grid_;
  int row_;
  std::vector<Node> nodes_;
  double noise_ = 0.0;
  double seen_ = 0.0;
};

/// Height of what a bead stands on: in a corner the parents, else the chord of the toes [m].
double reference(const RowBead& bead, double x);
}  // namespace weld
}  // namespace weld_profiler
