#include <cmath>

#include <gtest/gtest.h>

#include "simulation/scenes.h"
#include "support/circle_segment.h"

namespace weld_profiler
{
namespace
{
TEST(WeldVolume, OfAPrismIsAreaTimesLength)
{
  const SimulatedScan scan(plainWeld());
  EXPECT_NEAR(scan.weldVolume(0.01, 0.03) / (segmentArea(0.010, 0.002) * 0.02), 1.0, 2e-5);
  EXPECT_NEAR(scan.weldVolume(-1.0, 1.0), 2.5 * scan.weldVolume(0.01, 0.03), 1e-12) << "50 mm in all";
  EXPECT_EQ(scan.weldVolume(0.03, 0.01), 0.0);
}

TEST(WeldVolume, IsTheIntegralOfTheSectionsAreas)
{
  SceneParams scene = plainWeld();
  scene.frame_count = 0;
  scene.scan_length = 0.012;
  scene.speed = 0.001;
  scene.weld.ripple_height = 0.0001;
  scene.weld.crater_start = 0.001;
  scene.weld.start = 0.001;
  scene.weld.end_length = 0.003;
  scene.plates.misalignment = 0.0005;
  const auto sections = SimulatedScan(scene).weldSections();
  ASSERT_GT(sections.size(), 200U);
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < sections.size(); ++i)
    sum += 0.5 * (sections[i].area + sections[i + 1].area) * (sections[i + 1].s - sections[i].s);
  const double volume = SimulatedScan(scene).weldVolume(sections.front().s, sections.back().s);
  ASSERT_GT(volume, 5e-8);
  EXPECT_NEAR(sum / volume, 1.0, 2e-4) << "sections are 50 um apart, ripples 1.2 mm";
}

TEST(WeldVolume, OfABentLopsidedBeadIsThatOfItsRemoval)
{
  SceneParams scene = plainWeld();
  scene.weld.curvature = 10.0;
  scene.weld.crest_offset = 0.25;
  scene.weld.start = 0.001;
  scene.weld.length = 0.008;
  const SimulatedScan scan(scene);
  double removed = 0.0;
  const double step = 2e-5;
  for (double y = -0.001; y < 0.011; y += step)
    for (double x = -0.008; x < 0.008; x += step)
      removed += scan.removalHeight(x, y) * step * step;
  EXPECT_NEAR(removed / scan.weldVolume(0.0, 0.008), 1.0, 5e-4) << "the grid cuts the ends by up to 20 um of 8 mm";
}
}  // namespace
}  // namespace weld_profiler
