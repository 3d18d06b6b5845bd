#pragma once

#include "seam_sections.h"
#include "weld_profiler/weld/weld_result.h"

namespace weld_profiler
{
namespace weld
{
/// Whether a section's bead rises beyond doubt, however certain its width is.
bool standsOut(const WeldSection& section);

/// Takes the bead out of a section whose width is not certain enough, or whose face does not rise above its reference
/// by 3 sigma: no plausible-looking nonsense.
void refuseDoubtful(const WeldParams& params, WeldSection& section);

/// Where a bead ends the surface falls away: what lies below it before the first section with a bead, or behind the
/// last, is no pore.
void dropPoresBeyondEnds(WeldResult& result);

/// Length, measured share, volumes, ripples and statistics of a result whose sections are filled.
void summarise(const SeamSections& sections, const WeldParams& params, WeldResult& result);
}  // namespace weld
}  // namespace weld_profiler
