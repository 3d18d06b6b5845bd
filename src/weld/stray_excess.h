#pragma once

#include <cmath>
#include <vector>

#include "seam_surface.h"

namespace weld_profiler
{
namespace weld
{
constexpr double kClear = 1.5;  ///< tolerances that a spot's top must reach

/// How far each point of the grid departs from the surface.
struct StrayExcess
{
  std::vector<float> height;            ///< above the surface [m]; 0 where nothing is known
  std::vector<std::uint8_t> on_face;    ///< whether a point lies between the toes
  std::vector<std::int8_t> over_plate;  ///< of these, 1 above the nearer plate, 0 on it, -1 below
  std::vector<std::uint8_t> at_toe;     ///< of these, whether a toe is near
  std::vector<float> tolerances;        ///< the same in units of what the surface itself departs by
  std::vector<std::uint8_t> known;      ///< whether a point can be judged
  double unseen_depth = INFINITY;       ///< pits less deep are not told in a quarter of the face [m]
};

/// Points are held against the median of the sections around; on the face also against their neighbours across the
/// weld, over 1.5 mm to either side along the section: ripples lift those alike, a ball of spatter does not.
/// @param without  points known to be no part of the surface: neighbours of nothing; empty = none.
StrayExcess strayExcess(const ScanGrid& grid, const SectionSampler& sampler, const SeamSurface& surface,
                        const std::vector<std::uint8_t>& without);
}  // namespace weld
}  // namespace weld_profiler
