#pragma once

#include <string>

#include "weld_profiler/geometry/calibration.h"

namespace weld_profiler
{
/// Checks what interfaces of the calibration file promise: finite values, unit vectors within 1e-3 (then normalised),
/// |normal . axis| >= sin 5 deg, optical axis at least 5 deg off the stage axis, metres_per_unit > 0, known type.
/// @throws ConfigError naming the field, its value and the remedy, prefixed with origin.
void validateCalibration(Calibration& calibration, const std::string& origin);

/// Reads and validates a calibration file. `camera_info_url` (a ROS camera YAML, relative to this file; package:// must
/// have been resolved by the caller through resolve_url) takes the place of `camera`.
/// @throws ConfigError (content) or InputError (cannot be read), naming file, key and remedy.
Calibration loadCalibration(const std::string& path);

/// Reads the `camera_info_url` of a calibration file, empty when it holds its camera itself.
std::string cameraInfoUrl(const std::string& calibration_path);

/// Reads a ROS camera YAML (camera_calibration's format) into a CameraCalibration.
CameraCalibration loadCameraFile(const std::string& path);

/// Writes a calibration file whole or not at all. @throws InputError naming the path.
void saveCalibration(const Calibration& calibration, const std::string& path);
}  // namespace weld_profiler
