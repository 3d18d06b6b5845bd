#pragma once

#include <vector>

#include "compared_scans.h"
#include "weld_profiler/weld/compare_params.h"
#include "weld_profiler/weld/quantity.h"

namespace weld_profiler
{
namespace weld
{
/// Before less after over the weld and its surroundings, where both are known.
Quantity removedVolume(const ComparedScans& scans);

/// Of bead and spatter above the target. Bins that lie below it beyond doubt count nothing; the others count with their
/// sign, so that noise adds up to nothing.
/// @param target  removal volume of the scan before: its sigma is that of the target.
Quantity remainingVolume(const ComparedScans& scans, const CompareBins& bins, const Quantity& target);

/// Places that lie below the target and below the surface before by more than the limit and 3 sigma. Deepest first.
std::vector<OverGroundSpot> overGround(const ComparedScans& scans, const CompareBins& bins, const PathFrame& path,
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
