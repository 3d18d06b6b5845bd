#pragma once

#include <vector>

#include "straight_runs.h"
#include "weld_profiler/weld/weld_params.h"

namespace weld_profiler
{
namespace weld
{
/// The straight pieces of a row that are long enough for parents; a flat face may be among them.
/// @param noise  scatter of a node [m].
/// @param seen   a node farther off a line stands out from it [m].
std::vector<StraightRun> rowParents(const std::vector<Node>& nodes, double noise, double seen,
                                    const WeldParams& params);

/// The line of the part of a run that is away from its end at the weld: a flat flank that begins there bends the run's
/// own line. Through the medians of the part's outer thirds.
/// @param side  of the weld that the run lies on, -1 or 1.
Line clearLine(const std::vector<Node>& nodes, const StraightRun& run, int side, double length);
}  // namespace weld
}  // namespace weld_profiler
