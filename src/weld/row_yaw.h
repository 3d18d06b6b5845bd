#pragma once

#include "section_shape.h"
#include "weld_profiler/weld/weld_section.h"

namespace weld_profiler
{
namespace weld
{
/// Grows a row's sigmas by what an uncertain yaw leaves uncertain: a row is cut across the weld by the cosine of the
/// yaw, and with widths all slopes change, and with slopes every distance from a line.
void addYawUncertainty(const SectionShape& shape, WeldSection& section);
}  // namespace weld
}  // namespace weld_profiler
