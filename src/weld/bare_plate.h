#pragma once

#include <vector>

#include "row_outline.h"
#include "weld_profiler/weld/weld_params.h"

namespace weld_profiler
{
namespace weld
{
/// A plate's line continued over a row.
struct PlateLine
{
  int from = 0;  ///< node at which the plate ends
  int side = 1;  ///< that it is continued to, -1 or 1
  Line line;
};

/// Pieces of a plate too short for parents by themselves, seen between two things that rise from it: the outline lies
/// along the plate's line continued for a millimetre and more. Between them is no one bead.
std::vector<StraightRun> barePlate(const RowOutline& outline, const PlateLine& plate, const WeldParams& params);
}  // namespace weld
}  // namespace weld_profiler
