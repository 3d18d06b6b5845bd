#pragma once

#include <string>

#include "weld_profiler/geometry/calibration.h"

namespace weld_profiler
{
/// Turns package://pkg/path, file:///path or a plain path into a path. @throws ConfigError for a package not found.
std::string resolveUrl(const std::string& url);

/// Reads a calibration file named by path or URL.
/// @throws ConfigError, InputError as loadCalibration.
Calibration loadCalibrationFrom(const std::string& url);
}  // namespace weld_profiler
