#include "weld_profiler/core/errors.h"
#include "weld_profiler/simulation/scene_params.h"

namespace weld_profiler
{
namespace
{
SceneParams realistic()
{
  SceneParams scene;  // the defaults, and
  scene.weld.ripple_height = 0.0001;
  return scene;
}

void addHarshPart(SceneParams& scene)
{
  scene.plates.misalignment = 0.0004;
  scene.plates.angle_deg = 1.5;
  scene.weld.yaw_deg = 3.0;
  scene.weld.reinforcement = 0.0025;
  scene.weld.ripple_height = 0.00016;
  scene.weld.undercut_left = 0.0004;
  scene.weld.undercut_right = 0.0002;
  scene.spatter.count = 60;
  scene.gauge = SceneBlock{ 0.001, 0.020, 0.030, 0.010, 0.015 };
}

SceneParams harsh()
{
  SceneParams scene = realistic();
  addHarshPart(scene);
  scene.speed_variation = 0.3;
  scene.speckle.contrast = 0.2;
  scene.laser.specular = 1.5;
  scene.laser.bead_reflectance = 0.7;
  scene.laser.interreflection = 0.4;
  scene.laser.ghost = 0.06;
  scene.laser.glow = 0.02;
  scene.light.ambient = 60.0;
  scene.light.arc = 400.0;
  scene.light.flash_share = 0.03;
  scene.light.sparks = 30;
  scene.calibration.camera.distortion = { { -0.12, 0.15, 0.0006, -0.0004, 0.0 } };
  return scene;
}
}  // namespace

SceneParams scenePreset(const std::string& name)
{
  requireOneOf("preset", name, presetNames());
  return name == "harsh" ? harsh() : realistic();
}
}  // namespace weld_profiler
