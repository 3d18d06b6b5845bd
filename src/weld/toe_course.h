#pragma once

#include <vector>

#include "along_weld.h"
#include "parent_fit.h"

namespace weld_profiler
{
namespace weld
{
/// Where a side's toes run, whatever spatter moved some of them to: of each measured toe the middle one of itself and
/// of the straight courses that the toes before it and behind it take. Where one of the courses is missing a bead may
/// begin or end and its toes close in, while spatter lies outside of them: the inner one of the two that are left.
/// @param s       of each section, rising [m].
/// @param window  length of a course [m].
AlongWeld toeCourse(const std::vector<double>& s, const AlongWeld& toes, Side side, double window);
}  // namespace weld
}  // namespace weld_profiler
