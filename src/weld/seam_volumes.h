#pragma once

#include "seam_sections.h"
#include "weld_profiler/weld/weld_params.h"
#include "weld_profiler/weld/weld_result.h"

namespace weld_profiler
{
namespace weld
{
/// Median of the steps between sections: what each of them stands for along the weld, half of it on either side. NaN of
/// fewer than two [m].
double usualStep(const std::vector<WeldSection>& sections);

/// Volume, volume above the target and the length of weld that they are of, from the sections' areas. Sections without
/// an area are bridged over max_bridge, and over a spot where they show the bead's width; what is bridged counts in the
/// sigma. Longer breaks add nothing, neither to the volumes nor to their length.
void fillVolumes(const SeamSections& sections, const WeldParams& params, WeldResult& result);
}  // namespace weld
}  // namespace weld_profiler
