#pragma once

#include <vector>

#include "simulation/renderer.h"
#include "weld_profiler/simulation/weld_truth.h"

namespace weld_profiler
{
namespace simulation
{
/// The bead's true dimensions where each frame's sheet crosses the weld's path.
std::vector<WeldTruth> trueSections(const World& world);

/// The dimensions of one section. @param y_offset  fixed y of part y = 0.
WeldTruth measureSection(const Bead& bead, double s, double y_offset);
}  // namespace simulation
}  // namespace weld_profiler
