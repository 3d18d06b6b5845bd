#pragma once

#include <string>

#include <gtest/gtest.h>

#include "geometry/temporary_folder.h"
#include "weld_profiler/core/errors.h"
#include "weld_profiler/geometry/calibration_file.h"

const char* const kCamera = R"(camera:
  image_width: 1440
  image_height: 1080
  camera_matrix: [6000.0, 0.0, 719.5, 0.0, 6100.0, 539.5, 0.0, 0.0, 1.0]
  distortion_model: plumb_bob
  distortion_coefficients: [-0.1, 0.2, 0.001, -0.002, 0.05]
)";

const char* const kRest = R"(laser_plane:
  normal: [0.0, 0.8660254, 0.5]
  distance: 0.125
stage:
  type: linear
  joint: stage_joint
  axis: [0.0, -0.8660254, -0.5]
  metres_per_unit: 0.001
)";

inline std::string goodFile()
{
  return std::string("version: 1\n") + kCamera + kRest;
}

inline std::string replaced(std::string text, const std::string& old_text, const std::string& new_text)
{
  const std::size_t at = text.find(old_text);
  EXPECT_NE(at, std::string::npos) << old_text;
  return at == std::string::npos ? text : text.replace(at, old_text.size(), new_text);
}

/// The error that loading the text gives; empty when it loads.
inline std::string errorOf(const std::string& text)
{
  const TemporaryFolder folder;
  writeText(folder.file("rig.yaml"), text);
  try
  {
    weld_profiler::loadCalibration(folder.file("rig.yaml"));
  }
  catch (const weld_profiler::ConfigError& error)
  {
    return error.what();
  }
  return "";
}
