#pragma once

#include "simulation/bead.h"
#include "weld_profiler/simulation/weld_truth.h"

namespace weld_profiler
{
namespace simulation
{
/// The dimensions of one section; row and stage are left at 0. @param y_offset  fixed y of part y = 0.
WeldTruth measureSection(const Bead& bead, double s, double y_offset);

/// Between face and chord from one s to another [m^3].
double beadVolume(const Bead& bead, double from, double to);
}  // namespace simulation
}  // namespace weld_profiler
