#pragma once

#include <string>

#include "tools/compare_input.h"
#include "weld_profiler/scan/summary.h"
#include "weld_profiler/weld/scan_comparison.h"

namespace weld_profiler
{
/// A comparison and what it was made of.
struct CompareRecord
{
  const CompareSource& before;
  const CompareSource& after;
  const ScanComparison& comparison;
  WeldParams measuring;  ///< used
  CompareParams params;
  std::string weld_id;
};

/// compare.json (docs/report.md).
JsonObject compareJson(const CompareRecord& record);

/// Writes compare.json, difference.pcd and, if asked for, report.html and report.png: all of them or none. Those of an
/// earlier run are replaced, its report is removed when none is asked for.
/// @param directory  made if needed.
/// @throws InputError naming path and cause.
void writeComparison(const CompareRecord& record, bool report, const std::string& directory);

/// One line: volumes, over-ground places, what is missing.
std::string outcome(const ScanComparison& comparison);
}  // namespace weld_profiler
