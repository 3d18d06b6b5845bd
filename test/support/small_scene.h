#pragma once

#include "weld_profiler/simulation/simulated_scan.h"

namespace weld_profiler
{
/// A short scan of a narrow image region: quick to render, and a weld all the same.
inline SceneParams smallScene(int frames)
{
  SceneParams scene = scenePreset("realistic");
  scene.frame_count = frames;
  scene.calibration.camera.roi_x = 0;
  scene.calibration.camera.roi_y = 420;
  scene.calibration.camera.roi_width = 1440;
  scene.calibration.camera.roi_height = 240;
  return scene;
}
}  // namespace weld_profiler
