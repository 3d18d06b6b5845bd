#pragma once

#include "weld/compare_sections.h"

namespace weld_profiler
{
namespace weld_accuracy
{
/// Balls of spatter and pores that lie wholly in the scan beside what was told of them: one is found where a spot of
/// its kind is told within its outline and 0.1 mm around; what is told away from every true one is false.
Spots compareSpots(const MeasuredWeld& weld);
}  // namespace weld_accuracy
}  // namespace weld_profiler
