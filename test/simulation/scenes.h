#pragma once

#include <cmath>
#include <cstring>
#include <vector>

#include "weld_profiler/simulation/simulated_scan.h"

namespace weld_profiler
{
/// A flat plate under the default rig, stripe on row 540, nothing random: what a closed form can say something about.
inline SceneParams flatScene()
{
  SceneParams scene;
  scene.frame_count = 4;
  scene.weld.width = 0.0;
  scene.speckle.contrast = 0.0;
  scene.sensor.noise = false;
  scene.sensor.encoding = "mono16";
  scene.motion_blur = false;
  scene.laser.shading = 0.0;
  scene.calibration.camera.cy = 540.0;
  return scene;
}

/// b = 10 mm, h = 2 mm along y, without ends or ripples: the bead reaches from x = -5 to 5 mm, a circle of radius
/// (25 + 4) / 4 = 7.25 mm.
inline SceneParams plainWeld(int frame_count = 40)
{
  SceneParams scene;
  scene.frame_count = frame_count;
  scene.weld.start = -0.02;
  scene.weld.end_length = 0.0;
  return scene;
}

/// Weld yawed 7 deg, a gauge step, a marked corner, speed +-50 %, lens distortion: nothing in it is symmetric.
inline SceneParams chiralScene()
{
  SceneParams scene = scenePreset("realistic");
  scene.frame_count = 40;
  scene.speed = 0.02;
  scene.speed_variation = 0.5;
  scene.weld.yaw_deg = 7.0;
  scene.gauge = SceneBlock{ 0.001, 0.019, 0.022, 0.012, 0.012 };
  scene.marker = SceneBlock{ 0.0015, -0.024, 0.003, 0.006, 0.005 };
  scene.calibration.camera.distortion = { { -0.12, 0.15, 0.0006, -0.0004, 0.02 } };
  return scene;
}

/// A frame's pixels as numbers above the black level [DN of 8 bit].
inline std::vector<double> frameOf(const SimulatedScan& scan, int frame)
{
  std::vector<std::uint8_t> bytes;
  scan.render(frame, bytes);
  const bool wide = scan.encoding() == "mono16";
  std::vector<double> pixels(bytes.size() / (wide ? 2 : 1));
  for (std::size_t i = 0; i < pixels.size(); ++i)
  {
    std::uint16_t value = bytes[i];
    if (wide)
      std::memcpy(&value, &bytes[2 * i], 2);
    pixels[i] = (wide ? value / 257.0 : value) - scan.scene().sensor.black_level;
  }
  return pixels;
}

struct Moments
{
  double sum = 0.0, mean = 0.0, sigma = 0.0;
};

/// Light in a column within some rows of a centre: sum, centroid, standard deviation.
inline Moments columnMoments(const SimulatedScan& scan, const std::vector<double>& pixels, int u, double v)
{
  Moments result;
  constexpr int kRows = 14;
  double squares = 0.0;
  for (int row = static_cast<int>(v) - kRows; row <= static_cast<int>(v) + kRows + 1; ++row)
  {
    const double light = pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(scan.width()) + u];
    result.sum += light;
    result.mean += light * row;
    squares += light * row * row;
  }
  result.mean /= result.sum;
  result.sigma = std::sqrt(squares / result.sum - result.mean * result.mean);
  return result;
}
}  // namespace weld_profiler
