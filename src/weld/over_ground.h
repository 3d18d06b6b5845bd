#pragma once

#include <cstdint>
#include <vector>

#include "compared_scans.h"
#include "weld_profiler/weld/compare_params.h"

namespace weld_profiler
{
namespace weld
{
/// Places that were ground too deep, and which of the points of the scan before lie in them.
struct OverGround
{
  std::vector<OverGroundSpot> spots;  ///< deepest first
  std::vector<std::uint16_t> of;      ///< one a point of the grid: number of its place from 1, 0 = none
};

/// Places that lie below the target and below the surface before by more than the limit and 3 sigma.
OverGround overGround(const ComparedScans& scans, const CompareBins& bins, const PathFrame& path,
                      const CompareParams& params);

/// Areas that a reader must know of.
struct ComparedAreas
{
  double share = 0.0;   ///< of the zone before, seen in both
  double low = 0.0;     ///< below the target by more than the limit and no deeper than before [m^2]
  double higher = 0.0;  ///< higher after than before by more than the limit [m^2]
};

ComparedAreas comparedAreas(const ComparedScans& scans, const CompareBins& bins, double limit);
}  // namespace weld
}  // namespace weld_profiler
