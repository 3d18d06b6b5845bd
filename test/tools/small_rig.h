#pragma once

#include <string>

namespace weld_profiler
{
/// Of a scene: the default rig at a quarter of its pixels, so that a frame takes a moment.
inline const std::string kSmallRig = R"(preset: realistic
encoder_rate: 200
camera:
  image_width: 360
  image_height: 270
  camera_matrix: [1500.0, 0.0, 179.5, 0.0, 1500.0, 134.5, 0.0, 0.0, 1.0]
  distortion_model: plumb_bob
  distortion_coefficients: [0.0, 0.0, 0.0, 0.0, 0.0]
)";
}  // namespace weld_profiler
