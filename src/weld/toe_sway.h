#pragma once

#include <vector>

#include "seam_sections.h"

namespace weld_profiler
{
namespace weld
{
/// How far a side's mapped toe moves within `reach` along the weld on either side, of each section [m]. 0 where it does
/// no more than a steady weld's; large where a bead ends and its toes close in, which the map shows too late or too
/// early.
std::vector<double> toeSway(const SeamSections& sections, Side side, double reach);
}  // namespace weld
}  // namespace weld_profiler
