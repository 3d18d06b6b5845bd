#pragma once

#include <ostream>

#include "weld_profiler/weld/grinding.h"

namespace weld_profiler
{
/// Writes the passes of a plan as passes.csv (docs/weld-files.md): a line a pose, passes and points from 0, metres. In
/// the C locale, whatever the stream's.
void writePassesCsv(const GrindingPlan& plan, std::ostream& out);
}  // namespace weld_profiler
