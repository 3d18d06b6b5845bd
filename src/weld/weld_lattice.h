#pragma once

#include <cstddef>
#include <vector>

#include "weld_shape.h"

namespace weld_profiler
{
namespace weld
{
/// One row of a lattice: across the weld at one s.
struct LatticeRow
{
  ToePair toes;              ///< s is always set
  bool valid = false;        ///< the toes are known here
  int first = 0, last = -1;  ///< columns that are used; the outermost lie on the lattice's edge
  int left = 0, right = -1;  ///< columns that lie on the toes

  bool uses(int column) const { return valid && column >= first && column <= last; }
  bool between(int column) const { return valid && column >= left && column <= right; }
};

/// What is known of a weld at the nodes of a grid along and across its path. Columns are equal steps in q, but for
/// those next to a toe or to the edge, which lie right on it; so meshes end in lines, not in stairs, and triangles keep
/// their shape however the width changes. NaN = not known.
struct WeldLattice
{
  int columns = 0;
  double step_s = 0.0;  ///< between rows [m]
  std::vector<LatticeRow> rows;
  std::vector<double> q, x, y;    ///< rows x columns
  std::vector<double> bead;       ///< z of the bead, from toe to toe
  std::vector<double> target;     ///< z of the target as far as grinding can leave it: never above bead and parents
  std::vector<double> to_remove;  ///< bead above the target, along its normal, >= 0 [m]
  std::vector<double> area;       ///< of the node's share of the target; between the toes, else 0 [m^2]

  std::size_t at(int row, int column) const
  {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
  }
  int rowCount() const { return static_cast<int>(rows.size()); }
};

/// @param step    wanted between nodes [m].
/// @param margin  beyond the toes; negative = the lattice ends that far inside them [m].
/// @return without rows when the weld is shorter than a step.
/// @throws ConfigError when the step makes more nodes than memory should hold.
WeldLattice makeLattice(const WeldShape& shape, double step, double margin);
}  // namespace weld
}  // namespace weld_profiler
