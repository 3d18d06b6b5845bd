#pragma once

#include "weld_profiler/simulation/scene_params.h"

namespace weld_profiler
{
namespace simulation
{
/// Plates, welds, blocks, spatter, pores. @throws ConfigError naming field, value and range.
void checkPart(const SceneParams& scene);
}  // namespace simulation
}  // namespace weld_profiler
