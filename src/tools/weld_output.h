#pragma once

#include <string>
#include <vector>

#include "weld_profiler/core/scan.h"
#include "weld_profiler/ros/weld_files.h"

namespace weld_profiler
{
/// How scans are measured, and where that goes.
struct WeldTask
{
  WeldEvaluator evaluator;
  WeldRecordInfo info;
  bool report = true;
  std::string directory;  ///< exists; a second scan gets a folder scan_2 in it
};

/// Measures scans, writes their files and says on standard error what each shows.
/// @throws InputError naming path and cause; Interrupted, which says what of the scans' welds is missing: the files so
/// far stay, whole.
void measureWelds(const std::vector<Scan>& scans, const WeldTask& task);
}  // namespace weld_profiler
