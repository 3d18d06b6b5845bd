#pragma once

#include <string>
#include <vector>

#include "weld_profiler/core/scan.h"

namespace weld_profiler
{
/// Formats saveScan knows: pcd (binary, organised, the fields of scan_points), ply (binary, valid points), csv.
std::vector<std::string> scanFormats();

/// Writes a scan, whole or not at all (a temporary file beside the target, then renamed). `time` is since the first
/// row. Same scan -> same bytes.
/// @param comments  for the head of a PCD or PLY, one line each; a CSV has none.
/// @throws ConfigError unknown format, listing the known ones; InputError naming the path and the cause.
void saveScan(const Scan& scan, const std::string& path, const std::string& format,
              const std::vector<std::string>& comments = {});
}  // namespace weld_profiler
