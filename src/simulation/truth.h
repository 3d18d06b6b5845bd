#pragma once

#include <vector>

#include "simulation/renderer.h"

namespace weld_profiler
{
namespace simulation
{
/// True centre line of a frame at the middle of its exposure.
std::vector<TruthCentre> trueCentres(const World& world, int frame);
}  // namespace simulation
}  // namespace weld_profiler
