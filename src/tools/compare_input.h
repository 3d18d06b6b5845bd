#pragma once

#include <string>

#include "weld_profiler/core/scan.h"
#include "weld_profiler/ros/weld_files.h"
#include "weld_profiler/weld/weld_params.h"

namespace weld_profiler
{
/// A scan to be compared, and what the folder it lies in tells of it.
struct CompareSource
{
  std::string path;  ///< as given
  Scan scan;
  std::string weld_id;            ///< may be empty
  CalibrationRecord calibration;  ///< what weld.json says; empty = not known
  WeldParams measuring;           ///< with what the weld was measured; defaults where nothing says
};

/// Reads a folder as scan_bag and the action scan_weld leave it (scan.pcd, else weld_points.pcd; weld.json if it is
/// there), or a PCD file alone.
/// @throws InputError, ConfigError naming file, cause and remedy.
CompareSource readCompareSource(const std::string& path);
}  // namespace weld_profiler
