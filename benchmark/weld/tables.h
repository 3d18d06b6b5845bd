#pragma once

#include <vector>

#include "comparison/report.h"
#include "weld/acceptance.h"
#include "weld/weld_case.h"

namespace weld_profiler
{
namespace weld_accuracy
{
/// Prints what stands behind the bars and keeps it for the file: errors by kind, the worst welds, verdicts.
void reportDetails(const std::vector<WeldCase>& welds, comparison::Report& report);

/// Keeps the bars for the file; they are printed by printBars.
void reportBars(const std::vector<Bar>& bars, comparison::Report& report);
}  // namespace weld_accuracy
}  // namespace weld_profiler
