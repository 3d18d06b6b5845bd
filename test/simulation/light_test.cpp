#include "simulation/light.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "simulation/scenes.h"

namespace weld_profiler
{
namespace
{
using simulation::Light;

double mean(const std::vector<float>& field)
{
  double sum = 0.0;
  for (const float value : field)
    sum += value;
  return field.empty() ? 0.0 : sum / field.size();
}

TEST(Light, IsAbsentInTheRealisticPreset)
{
  EXPECT_TRUE(Light(scenePreset("realistic"), 144, 108).field(0).empty());
}

TEST(Light, IsHeldBackByTheFilter)
{
  SceneParams scene;
  scene.light.ambient = 100.0;
  const double behind = mean(Light(scene, 144, 108).field(0));
  scene.light.filter = false;
  const double open = mean(Light(scene, 144, 108).field(0));
  EXPECT_NEAR(open, 100.0, 15.0);
  EXPECT_NEAR(behind / open, scene.light.ambient_transmission, 1e-6);

  scene.light.ambient = 0.0;
  scene.light.arc = 1000.0;
  const double arc_open = mean(Light(scene, 144, 108).field(0));
  scene.light.filter = true;
  EXPECT_NEAR(mean(Light(scene, 144, 108).field(0)) / arc_open, scene.light.arc_transmission, 1e-6);
  EXPECT_GT(arc_open, 50.0);
}

TEST(Light, FlashesInTheAskedShareOfFrames)
{
  SceneParams scene;
  scene.light.flash_share = 0.1;
  const Light light(scene, 144, 108);
  int flashes = 0;
  for (int frame = 0; frame < 2000; ++frame)
  {
    flashes += light.flashes(frame) ? 1 : 0;
    if (frame < 100)
    {
      EXPECT_EQ(mean(light.field(frame)) > 20.0, light.flashes(frame)) << "frame " << frame;
    }
  }
  EXPECT_NEAR(flashes, 200, 45);  // binomial, 3 sigma = 40
}

TEST(Light, ThrowsSparksThatDifferFromFrameToFrame)
{
  SceneParams scene;
  scene.light.sparks = 20;
  const Light light(scene, 144, 108);
  const auto first = light.field(0);
  ASSERT_EQ(first.size(), 144U * 108U);
  EXPECT_GT(std::count_if(first.begin(), first.end(), [](float value) { return value > 30.0F; }), 20);
  EXPECT_FALSE(first == light.field(1));
  EXPECT_TRUE(first == light.field(0));
}

TEST(Light, ReachesThePicture)
{
  SceneParams scene = flatScene();
  scene.light.ambient = 100.0;
  const SimulatedScan scan(scene);
  const auto pixels = frameOf(scan, 0);
  EXPECT_NEAR(pixels[200U * 1440U + 720U], 10.0, 0.5);
  EXPECT_NEAR(pixels[540U * 1440U + 720U], 190.0, 0.5);
}
}  // namespace
}  // namespace weld_profiler
