#pragma once

#include <optional>
#include <vector>

#include "simulation/renderer.h"
#include "weld_profiler/simulation/weld_truth.h"

namespace weld_profiler
{
namespace simulation
{
/// The bead's true dimensions where each frame's sheet crosses the weld's path.
std::vector<WeldTruth> trueSections(const World& world);

/// The section through (x, y) of the fixed frame; row and stage of the nearest frame. None where there is no bead.
std::optional<WeldTruth> trueSection(const World& world, double x, double y);

/// Between face and chord from one s to another [m^3].
double trueVolume(const World& world, double from_s, double to_s);

/// See SimulatedScan::removalHeight().
double removalHeight(const World& world, double x, double y, double rest);
}  // namespace simulation
}  // namespace weld_profiler
