#pragma once

#include "compared_scans.h"
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
}  // namespace weld
}  // namespace weld_profiler
