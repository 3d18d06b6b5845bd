#pragma once

#include <cstdint>
#include <vector>

#include "seam_sections.h"

namespace weld_profiler
{
namespace weld
{
/// What of a bead can be told, one a section.
struct BeadCourse
{
  std::vector<std::uint8_t> known;   ///< whether what lies between its toes can
  std::vector<std::uint8_t> ending;  ///< whether what lies lower there may be the bead that ends
};

/// Where toes were found and the bead is about as high as around there, what lies between them can be told. Where it is
/// lower on to an end of the weld, or down to nothing, it is ending, from where it first is lower than ripples make it;
/// where it is lower in between it has a pore.
/// @param levels  of each section, median height of what lies between its toes [m].
BeadCourse beadCourse(const SeamSections& sections, const std::vector<double>& levels);
}  // namespace weld
}  // namespace weld_profiler
