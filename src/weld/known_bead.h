#pragma once

#include <cstdint>
#include <vector>

#include "seam_sections.h"

namespace weld_profiler
{
namespace weld
{
/// In which sections what lies between the toes can be told. Where toes were found and the bead is about as high as
/// around there, it can. Where it is lower on to an end of the weld, or down to nothing, it is ending; where it is
/// lower in between it has a pore.
/// @param levels  of each section, median height of what lies between its toes [m].
std::vector<std::uint8_t> knownBead(const SeamSections& sections, const std::vector<double>& levels);
}  // namespace weld
}  // namespace weld_profiler
