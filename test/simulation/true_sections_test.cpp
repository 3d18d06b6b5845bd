#include "simulation/true_sections.h"

#include <cmath>

#include <gtest/gtest.h>

#include "simulation/scenes.h"
#include "support/circle_segment.h"

namespace weld_profiler
{
namespace
{
constexpr double kRadPerDeg = M_PI / 180.0;

WeldTruth middleOf(const SceneParams& scene)
{
  const auto sections = SimulatedScan(scene).weldSections();
  EXPECT_EQ(sections.size(), 20U);
  return sections.empty() ? WeldTruth() : sections[10];
}

TEST(TrueSections, MeasureACircularSegment)
{
  const WeldTruth section = middleOf(plainWeld(20));
  EXPECT_EQ(section.row, 10);
  EXPECT_NEAR(section.stage, 10 * 0.005 / 20.0, 1e-12);
  EXPECT_NEAR(section.s, section.stage + 0.02, 1e-9);
  EXPECT_NEAR(section.width, 0.010, 1e-12);
  EXPECT_NEAR(section.reinforcement, 0.002, 1e-9);
  EXPECT_NEAR(section.height_left, 0.002, 1e-9);
  EXPECT_NEAR(section.toe_left[0], -0.005, 1e-12);
  EXPECT_NEAR(section.toe_right[0], 0.005, 1e-12);
  EXPECT_NEAR(section.toe_right[1], section.stage, 1e-9);
  EXPECT_NEAR(section.toe_right[2], 0.0, 1e-12);
  EXPECT_EQ(section.undercut_left + section.undercut_right + section.misalignment, 0.0);
  EXPECT_NEAR(section.area, segmentArea(0.010, 0.002), 1e-10);
}

TEST(TrueSections, TakeTheToeAngleFromTheFirstPieceOfTheFace)
{
  const WeldTruth section = middleOf(plainWeld(20));
  // the face leaves the plate at 43.6 deg; its chord to a third of the height is flatter
  const double third = 0.002 / 3.0, radius = 0.00725;
  const double q = std::sqrt(radius * radius - std::pow(third + radius - 0.002, 2.0));
  const double chord = std::atan2(third, 0.005 - q) / kRadPerDeg;
  EXPECT_NEAR(section.toe_angle_left / kRadPerDeg, 180.0 - chord, 0.3);  // regression and chord of a short arc
  EXPECT_NEAR(section.toe_angle_left, section.toe_angle_right, 1e-6);
}

TEST(TrueSections, SeeMisalignmentAndBothHeights)
{
  SceneParams scene = plainWeld(20);
  scene.plates.misalignment = 0.001;
  const WeldTruth section = middleOf(scene);
  EXPECT_NEAR(section.misalignment, 0.001, 1e-9);
  EXPECT_NEAR(section.width, std::hypot(0.010, 0.001), 1e-12);
  EXPECT_NEAR(section.toe_left[2], -0.0005, 1e-12);
  EXPECT_NEAR(section.toe_right[2], 0.0005, 1e-12);
  EXPECT_GT(section.height_left, section.height_right + 0.0008) << "the left plate lies lower";
  scene.plates.misalignment = -0.001;
  EXPECT_NEAR(middleOf(scene).misalignment, 0.001, 1e-9);
}

TEST(TrueSections, SeeUndercutOnTheRightSide)
{
  SceneParams scene = plainWeld(20);
  scene.weld.undercut_right = 0.0004;
  const WeldTruth section = middleOf(scene);
  EXPECT_NEAR(section.undercut_right, 0.0004, 1e-8);
  EXPECT_EQ(section.undercut_left, 0.0);
  EXPECT_NEAR(section.width, 0.010, 1e-12) << "the undercut is not part of the width";
}

TEST(TrueSections, LieAcrossAnObliqueWeld)
{
  SceneParams scene = plainWeld(20);
  scene.weld.yaw_deg = 20.0;
  const WeldTruth section = middleOf(scene);
  EXPECT_NEAR(section.yaw, 20.0 * kRadPerDeg, 1e-9);
  EXPECT_NEAR(section.width, 0.010, 1e-12) << "not 10 mm / cos 20 deg";
  EXPECT_NEAR(section.toe_right[0] - section.toe_left[0], 0.010 * std::cos(20.0 * kRadPerDeg), 1e-9);
  EXPECT_NEAR(section.toe_right[1] - section.toe_left[1], 0.010 * std::sin(20.0 * kRadPerDeg), 1e-9);
}

TEST(TrueSections, FollowACurvedWeld)
{
  SceneParams scene = plainWeld(20);
  scene.weld.curvature = 5.0;  // radius 200 mm, to the right
  const auto sections = SimulatedScan(scene).weldSections();
  ASSERT_EQ(sections.size(), 20U);
  for (const WeldTruth& section : sections)
  {
    const double x = 0.5 * (section.toe_left[0] + section.toe_right[0]);
    const double y = 0.5 * (section.toe_left[1] + section.toe_right[1]);
    const double middle = -0.02 + 0.025;  // of the weld, where it runs along y
    EXPECT_NEAR(std::hypot(x - 0.2, y - middle), 0.2, 1e-9);
    EXPECT_NEAR(section.yaw, -std::asin((y - middle) / 0.2), 1e-9);
  }
}

TEST(TrueSections, EndWhereTheWeldEnds)
{
  SceneParams scene = plainWeld(20);
  scene.weld.start = 0.0011;
  scene.weld.length = 0.002;
  scene.weld.end_length = 0.0005;
  const auto sections = SimulatedScan(scene).weldSections();
  ASSERT_EQ(sections.size(), 8U) << "y = 1.25 ... 3 mm";
  EXPECT_EQ(sections.front().row, 5);
  EXPECT_LT(sections.front().width, 0.0099);
  EXPECT_NEAR(sections[3].width, 0.010, 1e-12);
}

TEST(TrueSections, AgreeWithTheTruePointsOfTheSameRow)
{
  SceneParams scene = plainWeld(20);
  scene.weld.ripple_height = 0.0001;
  const SimulatedScan scan(scene);
  const auto sections = scan.weldSections();
  ASSERT_EQ(sections.size(), 20U);
  double crest = 0.0;
  for (const TruthCentre& centre : scan.truth(sections[8].row))
    crest = std::max(crest, centre.z);
  EXPECT_NEAR(sections[8].height_left, crest, 1e-6);
}
}  // namespace
}  // namespace weld_profiler
