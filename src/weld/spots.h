#pragma once

#include <cstdint>
#include <vector>

#include "seam_surface.h"
#include "weld_profiler/weld/weld_spot.h"

namespace weld_profiler
{
namespace weld
{
/// What a point of the grid is, that is no part of the surface.
enum class Stray : std::uint8_t
{
  None = 0,
  Spatter,  ///< above the surface, in a spot
  Pore,     ///< below it, in a spot
  Foreign   ///< off the surface over more than a spot: a clamp, another bead
};

/// Points that depart from the surface, and the spots they make.
struct Strays
{
  std::vector<Stray> kind;           ///< one a point of the grid
  std::vector<std::uint8_t> masked;  ///< points no dimension is told from: strays and their rims
  std::vector<WeldSpot> spots;       ///< rising s
  std::vector<WeldSpot> hollows;     ///< pits in the face that may be pores or not, rising s
  double widest_ball = 0.0;          ///< diameter [m]
  double widest_pit = 0.0;           ///< in the face, be it a pore or not [m]
  UnseenPores unseen;                ///< that may be there beside the spots
};

/// Points beyond the surface's tolerance that hang together make a spot, from 6 points on; one wider than 4 mm is
/// foreign. What lies below the surface without a rim on the face may be a pore or not, and is foreign as well.
/// @param without  points known to be strays from an earlier look; empty = none.
Strays findStrays(const ScanGrid& grid, const SectionSampler& sampler, const SeamSurface& surface,
                  const std::vector<std::uint8_t>& without);
}  // namespace weld
}  // namespace weld_profiler
