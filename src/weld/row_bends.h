#pragma once

#include <cstdint>
#include <vector>

#include "section_sampler.h"

namespace weld_profiler
{
namespace weld
{
/// How much a face bends from row to row, and so how far straight lines between rows may leave it: half its second
/// derivative along the columns, quadratic mean over a stretch of weld. A line between rows d1 and d2 away errs by this
/// times d1 d2.
/// @param masked   points to leave out, one a point of the grid; empty = none.
/// @param places   s of each section, rising.
/// @param crests   q of the middle of each section's face; NaN = not known.
/// @return         of each section; 0 where no three neighbouring rows show any [1/m].
std::vector<double> rowBends(const SectionSampler& sampler, const std::vector<std::uint8_t>& masked,
                             const std::vector<double>& places, const std::vector<double>& crests);
}  // namespace weld
}  // namespace weld_profiler
