#pragma once

#include <functional>
#include <string>

#include "weld_profiler/geometry/calibration.h"

namespace weld_profiler
{
/// Checks what the calibration file promises: finite values, unit vectors within 1e-3 (then normalised; the plane stays
/// where it is), |normal . axis| >= sin 5 deg, optical axis at least 5 deg off the stage axis and meeting the laser
/// plane in front of the camera, metres_per_unit > 0, known type.
/// @param origin  file name or the like, first word of each message.
/// @throws ConfigError naming origin, field, value and the remedy.
void validateCalibration(Calibration& calibration, const std::string& origin);

/// The camera's part of validateCalibration.
void validateCamera(const CameraCalibration& camera, const std::string& origin);

/// Turns a package:// URL into a path. The core knows no ROS packages, nodelets hand one in.
using UrlResolver = std::function<std::string(const std::string& url)>;

/// Reads and validates a calibration file. `camera_info_url` (a ROS camera YAML: a path relative to this file,
/// absolute, file://, or package:// through resolve) takes the place of `camera`. Keys it does not know are accepted.
/// @throws ConfigError (content) or InputError (cannot be read), naming file, key and remedy.
Calibration loadCalibration(const std::string& path, const UrlResolver& resolve = {});

/// Reads the `camera_info_url` of a calibration file, empty when it holds its camera itself.
std::string cameraInfoUrl(const std::string& calibration_path);

/// Reads a ROS camera YAML (camera_calibration's format) into a CameraCalibration; `binning_x`, `binning_y` and `roi`
/// (x_offset y_offset width height) are read if there. Validated.
CameraCalibration loadCameraFile(const std::string& path);

/// The text of a calibration file; loadCalibration reads the very same values back.
std::string calibrationText(const Calibration& calibration);

/// Writes a calibration file whole or not at all. @throws InputError naming the path; ConfigError when it would not
/// load.
void saveCalibration(const Calibration& calibration, const std::string& path);
}  // namespace weld_profiler
