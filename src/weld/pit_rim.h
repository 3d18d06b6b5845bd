#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "scan_grid.h"

namespace weld_profiler
{
namespace weld
{
/// Which share of the places around a pit shows the face. The rest was not measured, lies beyond a toe or is a stray.
/// @param pit   points of the grid, at least one.
/// @param face  of each point of the grid, whether it was measured on the face.
double faceAround(const ScanGrid& grid, const std::vector<std::size_t>& pit, const std::vector<std::uint8_t>& face);

/// How many places are hidden beside a pit: missing in its rows from its points on, over more than a rim.
std::size_t hiddenBeside(const ScanGrid& grid, const std::vector<std::size_t>& pit);

/// Marks the points of the grid around one, up to `reach` beside it [m].
void maskAround(const ScanGrid& grid, std::size_t point, double reach, std::vector<std::uint8_t>& masked);
}  // namespace weld
}  // namespace weld_profiler
