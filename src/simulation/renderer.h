#pragma once

#include "simulation/light.h"
#include "simulation/sensor.h"

namespace weld_profiler
{
namespace simulation
{
/// Everything a scan is made of, built once. Immutable, thread safe.
struct World
{
  explicit World(const SceneParams& params);
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  SceneParams scene;
  Motion motion;
  Rig rig;
  Surface surface;
  Shader shader;
  Speckle speckle;
  Light light;
  Sensor sensor;

  double frameTime(int frame) const { return motion.seconds(motion.stamp(frame)); }

  /// Moments into which an exposure is cut [s since the first frame].
  std::vector<double> moments(int frame) const;

  SheetCut cut(double seconds) const { return SheetCut(surface, rig, rig.pose(seconds)); }
};

/// Renders one frame of a world.
void renderFrame(const World& world, int frame, std::vector<std::uint8_t>& pixels);
}  // namespace simulation
}  // namespace weld_profiler
