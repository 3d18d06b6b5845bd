#pragma once

#include "weld_profiler/ros/weld_files.h"
#include "weld_profiler/scan/summary.h"

namespace weld_profiler
{
/// weld.json: what was measured of the weld as a whole, the settings, the calibration (docs/weld-files.md).
JsonObject weldRecord(const Scan& scan, const WeldEvaluation& evaluation, const WeldSettings& settings,
                      const WeldRecordInfo& info);
}  // namespace weld_profiler
