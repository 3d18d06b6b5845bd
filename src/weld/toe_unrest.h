#pragma once

#include <vector>

namespace weld_profiler
{
namespace weld
{
/// By how much each toe departs from the line between those half a millimetre beside it, as the standard deviation of
/// one: a toe that runs obliquely is at rest. NaN where those are not known [m].
/// @param places  of the sections, rising [m].
/// @param toes    of each, q; NaN = not found [m].
std::vector<double> toeUnrest(const std::vector<double>& places, const std::vector<double>& toes);

/// Sections that show the toe, or lie between such: 1. The scan's ends count as showing it unless the bead begins or
/// ends before.
std::vector<char> sectionsWithToe(const std::vector<double>& places, const std::vector<double>& toes, bool begins,
                                  bool ends);
}  // namespace weld
}  // namespace weld_profiler
