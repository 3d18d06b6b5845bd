#pragma once

#include <vector>

#include "comparison/report.h"
#include "weld/weld_case.h"

namespace weld_profiler
{
namespace weld_accuracy
{
/// What share of the true sections was measured, by kind.
void reportShares(const std::vector<WeldCase>& welds, comparison::Report& report);

/// What share of the true spatter was told, and how much is told where there is none.
void reportSpots(const std::vector<WeldCase>& welds, comparison::Report& report);
}  // namespace weld_accuracy
}  // namespace weld_profiler
