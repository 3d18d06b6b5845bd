#pragma once

#include <vector>

#include "weld/bar.h"
#include "weld/weld_case.h"

namespace weld_profiler
{
namespace weld_accuracy
{
/// The bars of accuracy, honesty, kinds, verdicts, labels and speed.
std::vector<Bar> acceptanceOf(const std::vector<WeldCase>& welds);
}  // namespace weld_accuracy
}  // namespace weld_profiler
