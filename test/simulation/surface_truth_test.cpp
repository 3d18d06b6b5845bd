#include <cmath>

#include <gtest/gtest.h>

#include "simulation/scenes.h"

namespace weld_profiler
{
namespace
{
TEST(WeldSection, ThroughAPointIsThatOfThePathsPointBesideIt)
{
  SceneParams scene = plainWeld();
  scene.weld.yaw_deg = 12.0;
  scene.weld.curvature = 4.0;
  const SimulatedScan scan(scene);
  const auto sections = scan.weldSections();
  ASSERT_EQ(sections.size(), 40U);
  for (const WeldTruth& section : { sections[3], sections[30] })
  {
    const auto again = scan.weldSection(section.toe_right[0], section.toe_right[1]);
    ASSERT_TRUE(again.has_value());
    EXPECT_NEAR(again->s, section.s, 1e-12);
    EXPECT_NEAR(again->yaw, section.yaw, 1e-12);
    EXPECT_EQ(again->row, section.row);
    EXPECT_NEAR(again->width, section.width, 1e-12);
  }
  EXPECT_FALSE(scan.weldSection(0.0, 0.2).has_value()) << "beyond the weld";
}

TEST(SurfaceLabel, NamesPlateBeadUndercutAndBlock)
{
  SceneParams scene = plainWeld();
  scene.weld.undercut_right = 0.0004;
  scene.weld.undercut_width = 0.0012;
  scene.gauge = SceneBlock{ 0.001, 0.015, 0.0, 0.004, 0.01 };
  const SimulatedScan scan(scene);
  EXPECT_EQ(scan.surfaceLabel(0.0, 0.001), TrueLabel::Bead);
  EXPECT_EQ(scan.surfaceLabel(-0.00499, 0.001), TrueLabel::Bead);
  EXPECT_EQ(scan.surfaceLabel(-0.00501, 0.001), TrueLabel::Base) << "no undercut on the left";
  EXPECT_EQ(scan.surfaceLabel(0.0053, 0.001), TrueLabel::Undercut);
  EXPECT_EQ(scan.surfaceLabel(0.00617, 0.001), TrueLabel::Base) << "less than 20 um deep";
  EXPECT_EQ(scan.surfaceLabel(0.015, 0.001), TrueLabel::Unknown);
  EXPECT_EQ(scan.surfaceLabel(-0.02, 0.001), TrueLabel::Base);
  EXPECT_EQ(scan.surfaceLabel(0.0, 0.04), TrueLabel::Base) << "beyond the weld's end";
}

TEST(Removal, IsTheFaceAboveTheChordAndNothingOnThePlates)
{
  SceneParams scene = plainWeld();
  scene.plates.misalignment = 0.001;
  scene.weld.undercut_left = 0.0003;
  const SimulatedScan scan(scene);
  EXPECT_NEAR(scan.removalHeight(0.0, 0.001), 0.002, 1e-12);
  EXPECT_NEAR(scan.targetHeight(0.0, 0.001), 0.0, 1e-12) << "half way between the plates";
  EXPECT_NEAR(scan.targetHeight(0.0025, 0.001), 0.00025, 1e-12) << "on the chord";
  EXPECT_NEAR(scan.targetHeight(0.0051, 0.001), 0.0005, 1e-12) << "on the right plate";
  EXPECT_NEAR(scan.targetHeight(-0.02, 0.001), -0.0005, 1e-12);
  EXPECT_EQ(scan.removalHeight(0.02, 0.001), 0.0);
  EXPECT_EQ(scan.removalHeight(-0.0053, 0.001), 0.0) << "an undercut needs no grinding";
  const double rest = 0.0003 * std::hypot(1.0, 0.1);  // along the chord's normal: it rises by 1 mm in 10
  EXPECT_NEAR(scan.removalHeight(0.0, 0.001, 0.0003), 0.002 - rest, 1e-12) << "a rest stays";
  EXPECT_EQ(scan.removalHeight(0.0, 0.001, 0.005), 0.0);
  EXPECT_NEAR(scan.targetHeight(0.0, 0.001, 0.0003), rest, 1e-12);
  EXPECT_NEAR(scan.targetHeight(0.02, 0.001, 0.0003), 0.0005, 1e-12) << "not on the plates";
}

TEST(Removal, OfAFilletIsItsConvexity)
{
  SceneParams scene = plainWeld();
  scene.weld.kind = "fillet";
  scene.plates.angle_deg = 90.0;
  scene.weld.reinforcement = 0.001;
  const SimulatedScan scan(scene);
  EXPECT_NEAR(scan.removalHeight(0.0, 0.001), 0.001, 1e-12);
  EXPECT_NEAR(scan.targetHeight(0.003, 0.001), 0.005, 1e-12);
  EXPECT_EQ(scan.removalHeight(0.008, 0.001), 0.0);
  EXPECT_NEAR(scan.surfaceHeight(0.008, 0.001), 0.008, 1e-12);
}

TEST(Removal, IsUnknownUnderABlock)
{
  SceneParams scene = plainWeld();
  scene.gauge = SceneBlock{ 0.001, 0.015, 0.0, 0.004, 0.01 };
  EXPECT_TRUE(std::isnan(SimulatedScan(scene).removalHeight(0.015, 0.001)));
}

TEST(Spots, AreBallsAndPitsOfTheirSize)
{
  SceneParams scene = plainWeld();
  scene.spatter.count = 40;
  scene.pores.count = 12;
  const SimulatedScan scan(scene);
  int pores = 0, balls = 0;
  for (const TrueSpot& spot : scan.spots())
  {
    const double x = spot.position[0], y = spot.position[1];
    if (y < -0.005 || y > 0.012 || std::abs(x) > 0.029)
      continue;
    const bool pore = spot.kind == TrueSpot::Kind::Pore;
    (pore ? pores : balls) += 1;
    if (pore)
    {
      EXPECT_NEAR(scan.surfaceHeight(x, y), spot.position[2], 1e-12);
      EXPECT_LT(spot.height, -0.2 * spot.diameter);
      EXPECT_EQ(scan.surfaceLabel(x, y), TrueLabel::Bead);
      EXPECT_LT(std::abs(x), 0.0045);
    }
    else
    {
      EXPECT_GE(scan.surfaceHeight(x, y), spot.position[2] - 1e-12) << "two balls may overlap";
      EXPECT_GT(spot.height, 1.2 * 0.5 * spot.diameter);
      EXPECT_EQ(scan.surfaceLabel(x, y), TrueLabel::Spatter);
      EXPECT_GT(scan.removalHeight(x, y), 0.0);
    }
  }
  EXPECT_GT(pores, 2);
  EXPECT_GT(balls, 20);
}

TEST(Spots, OfAFlatPlateStandOutByTheirRadiusAndAShare)
{
  SceneParams scene = plainWeld();
  scene.weld.width = 0.0;
  scene.spatter.count = 3;
  for (const TrueSpot& spot : SimulatedScan(scene).spots())
    EXPECT_NEAR(spot.height, 0.7 * spot.diameter, 1e-12);
  EXPECT_EQ(SimulatedScan(scene).spots().size(), 3U);
}

TEST(Spots, ArePitsOfTheAskedDepthWithinTheirRim)
{
  SceneParams scene = plainWeld();
  scene.weld.reinforcement = 0.0;
  scene.pores = ScenePores{ 5, 0.001, 0.001, 0.3 };
  const SimulatedScan scan(scene);
  ASSERT_EQ(scan.spots().size(), 5U);
  for (const TrueSpot& spot : scan.spots())
  {
    EXPECT_NEAR(spot.height, -0.0003, 1e-12);
    EXPECT_EQ(spot.diameter, 0.001);
    if (spot.position[1] < -0.008 || spot.position[1] > 0.015)
      continue;  // beyond the surface's grid
    EXPECT_EQ(scan.surfaceHeight(spot.position[0] + 0.000501, spot.position[1]), 0.0);
    EXPECT_LT(scan.surfaceHeight(spot.position[0] + 0.00049, spot.position[1]), -5e-6);
  }
}

TEST(Spots, AreInTheCloudsFrameWhereverTheStageStarts)
{
  SceneParams scene = plainWeld();
  scene.pores.count = 4;
  const auto here = SimulatedScan(scene).spots();
  scene.start_position = 0.31;
  const SimulatedScan scan(scene);
  ASSERT_EQ(scan.spots().size(), 4U);
  for (std::size_t i = 0; i < 4U; ++i)
  {
    EXPECT_NEAR(scan.spots()[i].position[0], here[i].position[0], 1e-12);
    EXPECT_NEAR(scan.spots()[i].position[1], here[i].position[1] + 0.31, 1e-12);
    EXPECT_NEAR(scan.spots()[i].s, here[i].s, 1e-12);
  }
}

TEST(Spots, AreTheSameForTheSameSeedOnly)
{
  SceneParams scene = plainWeld();
  scene.pores.count = 5;
  const double first = SimulatedScan(scene).spots()[0].position[0];
  EXPECT_EQ(SimulatedScan(scene).spots()[0].position[0], first);
  scene.seed = 2;
  EXPECT_NE(SimulatedScan(scene).spots()[0].position[0], first);
}

TEST(Ripples, AreThoseOfTheScene)
{
  SceneParams scene = plainWeld();
  EXPECT_EQ(SimulatedScan(scene).ripples().height, 0.0);
  scene.weld.ripple_height = 0.0002;
  scene.weld.ripple_pitch = 0.002;
  const SimulatedScan scan(scene);
  EXPECT_EQ(scan.ripples().height, 0.0002);
  EXPECT_EQ(scan.ripples().pitch, 0.002);
  double low = 1.0, high = 0.0;
  for (double y = 0.0; y < 0.004; y += 1e-5)
  {
    low = std::min(low, scan.surfaceHeight(0.0, y));
    high = std::max(high, scan.surfaceHeight(0.0, y));
  }
  EXPECT_NEAR(high - low, 0.0002, 1e-8);
  const double y = scan.weldSections()[7].toe_left[1];
  EXPECT_NEAR(scan.weldSections()[7].reinforcement, scan.surfaceHeight(0.0, y), 1e-7) << "that of the exact section";
}
}  // namespace
}  // namespace weld_profiler
