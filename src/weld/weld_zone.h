#pragma once

#include <cstdint>
#include <vector>

#include "scan_grid.h"
#include "weld_profiler/weld/weld_result.h"

namespace weld_profiler
{
namespace weld
{
/// A measured scan in the order of its grid.
struct GridMaps
{
  std::vector<std::uint8_t> labels;  ///< WeldLabel
  std::vector<float> target;         ///< [m]
};

/// Whether grinding takes what a point lies on: bead or spatter.
bool isMetal(std::uint8_t label);

GridMaps gridMaps(const ScanGrid& grid, const WeldResult& result);

/// How far each point lies from the weld's nearest (bead, undercut, spatter), seen from above [m].
std::vector<float> distanceToWeld(const ScanGrid& grid, const std::vector<std::uint8_t>& labels);
}  // namespace weld
}  // namespace weld_profiler
