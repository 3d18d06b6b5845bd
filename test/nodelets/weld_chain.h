#pragma once

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "support/chain_under_test.h"

namespace weld_profiler
{
constexpr int kFrames = 60;

/// 15 mm of the weld's middle.
inline SceneParams weldScene(double yaw)
{
  SceneParams scene = smallScene(kFrames);
  scene.part_start = 0.018;
  scene.plates.misalignment = 0.0003;
  scene.weld.yaw_deg = yaw * 180.0 / M_PI;
  return scene;
}

struct WeldChain : Chain
{
  explicit WeldChain(const std::string& name, double yaw = 0.0) : Chain(name, weldScene(yaw))
  {
    manager.set("weld_measurement", "report", false);
    manager.set("weld_measurement", "output", folder.file("welds"));
    manager.set("weld_measurement", "rest_time", 0.5);
  }

  void loadAll()
  {
    load();
    ASSERT_TRUE(manager.load("weld_measurement"));
  }

  void feedAll()
  {
    for (int frame = 0; frame < kFrames; ++frame)
      feed.publishFrame(frame);
  }
};
}  // namespace weld_profiler
