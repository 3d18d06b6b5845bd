#include <cmath>

#include <gtest/gtest.h>

#include "simulation/scenes.h"
#include "support/circle_segment.h"

namespace weld_profiler
{
namespace
{
constexpr double kRadPerDeg = M_PI / 180.0;

SceneParams plainWeld(const std::string& kind)
{
  SceneParams scene = weld_profiler::plainWeld(12);
  scene.weld.kind = kind;
  if (kind == "fillet")
    scene.plates.angle_deg = 90.0;
  return scene;
}

WeldTruth middleOf(const SceneParams& scene)
{
  const auto sections = SimulatedScan(scene).weldSections();
  EXPECT_EQ(sections.size(), 12U);
  return sections.empty() ? WeldTruth() : sections[6];
}

TEST(WeldKinds, AFilletHasLegsAndThroatOfItsTriangle)
{
  SceneParams scene = plainWeld("fillet");
  scene.weld.reinforcement = 0.0012;
  const WeldTruth section = middleOf(scene);
  EXPECT_EQ(section.kind, "fillet");
  EXPECT_NEAR(section.leg_left, 0.005 * M_SQRT2, 1e-9);
  EXPECT_NEAR(section.leg_right, 0.005 * M_SQRT2, 1e-9);
  EXPECT_NEAR(section.throat, 0.005, 1e-9);
  EXPECT_NEAR(section.width, 0.010, 1e-9);
  EXPECT_NEAR(section.convexity, 0.0012, 1e-9);
  EXPECT_NEAR(section.reinforcement, 0.0012, 1e-9);
  EXPECT_NEAR(section.angle, M_PI / 2.0, 1e-9);
  EXPECT_NEAR(section.area, segmentArea(0.010, 0.0012), 1e-10);
  EXPECT_EQ(section.incomplete_fill, 0.0);
  EXPECT_EQ(section.undercut_left + section.undercut_right, 0.0);
}

TEST(WeldKinds, ATiltedFilletHasUnequalLegs)
{
  SceneParams scene = plainWeld("fillet");
  scene.plates.tilt_deg = 10.0;
  scene.weld.reinforcement = 0.0;
  const WeldTruth section = middleOf(scene);
  const double left = 0.005 / std::cos(35.0 * kRadPerDeg), right = 0.005 / std::cos(55.0 * kRadPerDeg);
  EXPECT_NEAR(section.leg_left, left, 1e-9);
  EXPECT_NEAR(section.leg_right, right, 1e-9);
  EXPECT_NEAR(section.width, std::hypot(left, right), 1e-9) << "the plates still stand at a right angle";
  EXPECT_NEAR(section.throat, left * right / std::hypot(left, right), 1e-9);
  EXPECT_NEAR(section.angle, M_PI / 2.0, 1e-9);
  EXPECT_NEAR(section.toe_angle_left + section.toe_angle_right, 1.5 * M_PI, 1e-6) << "a triangle's angles";
  EXPECT_NEAR(section.convexity, 0.0, 1e-12);
}

TEST(WeldKinds, AFlatFilletsToesAre135Degrees)
{
  SceneParams scene = plainWeld("fillet");
  scene.weld.reinforcement = 0.0;
  EXPECT_NEAR(middleOf(scene).toe_angle_left / kRadPerDeg, 135.0, 1e-6);
}

TEST(WeldKinds, AConvexFilletsToeAngleLacksTheFacesOwn)
{
  SceneParams scene = plainWeld("fillet");
  scene.weld.reinforcement = 0.001;
  // the first millimetre along an arc of radius 13 mm turns by 1/13 rad; a regression sees its middle
  const double edge = 2.0 * std::atan(0.2), turn = 1.0 / 13.0;
  EXPECT_NEAR(middleOf(scene).toe_angle_left, 0.75 * M_PI - edge + 0.5 * turn, 0.1 * kRadPerDeg);
}

TEST(WeldKinds, AHollowFilletIsConcave)
{
  SceneParams scene = plainWeld("fillet");
  scene.weld.reinforcement = -0.0008;
  const WeldTruth section = middleOf(scene);
  EXPECT_NEAR(section.convexity, -0.0008, 1e-9);
  EXPECT_NEAR(section.incomplete_fill, 0.0008, 1e-9);
  EXPECT_EQ(section.reinforcement, 0.0);
  EXPECT_NEAR(section.area, -segmentArea(0.010, 0.0008), 1e-10);
  EXPECT_NEAR(section.throat, 0.005, 1e-9) << "to the chord";
  EXPECT_GT(section.toe_angle_left, 0.75 * M_PI);
}

TEST(WeldKinds, AHollowButtWeldIsIncompletelyFilled)
{
  SceneParams scene = plainWeld("butt");
  scene.weld.reinforcement = -0.0005;
  const WeldTruth section = middleOf(scene);
  EXPECT_NEAR(section.incomplete_fill, 0.0005, 1e-9);
  EXPECT_EQ(section.reinforcement, 0.0);
  EXPECT_NEAR(section.width, 0.010, 1e-12);
  EXPECT_EQ(section.undercut_left, 0.0);
  EXPECT_TRUE(std::isnan(section.leg_left) && std::isnan(section.throat) && std::isnan(section.convexity));
}

TEST(WeldKinds, AHollowFacesToeAngleMirrorsThatOfABead)
{
  SceneParams scene = plainWeld("butt");
  scene.weld.width = 0.005;
  scene.weld.reinforcement = 0.0006;
  const double bead = middleOf(scene).toe_angle_left;
  scene.weld.reinforcement = -0.0006;
  EXPECT_NEAR(middleOf(scene).toe_angle_left, 2.0 * M_PI - bead, 1e-9) << "over a third of the depth";
}

TEST(WeldKinds, MisalignmentTiltsTheChordAndTheReinforcementIsPerpendicularToIt)
{
  SceneParams scene = plainWeld("butt");
  scene.plates.misalignment = 0.001;
  const WeldTruth section = middleOf(scene);
  const double tilt = std::atan(0.1);
  EXPECT_NEAR(section.width, 0.010 / std::cos(tilt), 1e-9);
  EXPECT_NEAR(section.reinforcement, 0.002 * std::cos(tilt), 1e-9) << "the arc is laid over the chord along z";
  EXPECT_NEAR(section.area, segmentArea(0.010, 0.002), 1e-10);
  EXPECT_NEAR(section.angle, 0.0, 1e-12);
}

TEST(WeldKinds, MisalignmentOfATiltedPairIsPerpendicularToIt)
{
  SceneParams scene = plainWeld("butt");
  scene.plates.misalignment = 0.001;
  scene.plates.tilt_deg = 20.0;
  EXPECT_NEAR(middleOf(scene).misalignment, 0.001 * std::cos(20.0 * kRadPerDeg), 1e-9);
}

TEST(WeldKinds, TheCrestStandsWhereItIsPut)
{
  SceneParams scene = plainWeld("bead_on_plate");
  scene.weld.crest_offset = 0.2;
  const SimulatedScan scan(scene);
  const double y = scan.weldSections()[6].toe_left[1];
  EXPECT_NEAR(scan.surfaceHeight(0.001, y), 0.002, 1e-12);
  EXPECT_LT(scan.surfaceHeight(0.0007, y), 0.002);
  EXPECT_LT(scan.surfaceHeight(0.0013, y), 0.002);
  const WeldTruth section = middleOf(scene);
  EXPECT_NEAR(section.reinforcement, 0.002, 1e-9);
  EXPECT_NEAR(section.width, 0.010, 1e-12);
  EXPECT_GT(section.toe_angle_left, section.toe_angle_right + 5.0 * kRadPerDeg) << "steeper on the right";
}

TEST(WeldKinds, ACraterIsDeepestInItsMiddle)
{
  SceneParams scene = plainWeld("bead_on_plate");
  scene.weld.start = 0.0;
  scene.weld.length = 0.030;
  scene.weld.crater_start = 0.0006;
  scene.weld.crater_end = 0.001;
  scene.weld.crater_length = 0.004;
  scene.scan_length = 0.030;
  const SimulatedScan scan(scene);
  EXPECT_NEAR(scan.surfaceHeight(0.0, 0.002), 0.002 - 0.0006, 1e-12);
  EXPECT_NEAR(scan.surfaceHeight(0.0, 0.015), 0.002, 1e-12);
  EXPECT_NEAR(scan.surfaceHeight(0.0, 0.028), 0.002 - 0.001, 1e-12);
}

TEST(WeldKinds, TacksAreShortBeadsWithPlateBetween)
{
  SceneParams scene = plainWeld("bead_on_plate");
  scene.weld.start = 0.0;
  scene.weld.length = 0.022;
  scene.weld.tack_length = 0.005;
  scene.weld.tack_gap = 0.003;
  scene.weld.end_length = 0.001;
  scene.frame_count = 0;
  scene.scan_length = 0.030;
  const SimulatedScan scan(scene);
  for (const double y : { 0.0025, 0.0105, 0.0185 })
    EXPECT_NEAR(scan.surfaceHeight(0.0, y), 0.002, 1e-12) << y;
  for (const double y : { 0.0065, 0.0145, 0.0225, 0.027 })
    EXPECT_NEAR(scan.surfaceHeight(0.0, y), 0.0, 1e-12) << y;
  EXPECT_TRUE(scan.weldSection(0.0, 0.0105).has_value());
  EXPECT_FALSE(scan.weldSection(0.0, 0.0065).has_value());
  const auto sections = scan.weldSections();
  EXPECT_NEAR(static_cast<double>(sections.size()), 15.0 / 0.25, 3.0) << "three tacks of 5 mm at a pitch of 0.25 mm";
}

TEST(WeldKinds, ASecondBeadLiesBesideTheFirst)
{
  SceneParams scene = plainWeld("bead_on_plate");
  scene.second_bead = SceneSecondBead{ 0.015, 0.006, 0.0008 };
  const SimulatedScan scan(scene);
  EXPECT_NEAR(scan.surfaceHeight(0.015, 0.001), 0.0008, 1e-12);
  EXPECT_NEAR(scan.surfaceHeight(0.0179, 0.001), 0.0008 * (1.0 - std::pow(2.9 / 3.0, 2.0)), 1e-5);
  EXPECT_EQ(scan.surfaceHeight(0.0181, 0.001), 0.0);
  EXPECT_EQ(scan.surfaceLabel(0.015, 0.001), TrueLabel::Bead);
  EXPECT_NEAR(middleOf(scene).width, 0.010, 1e-12) << "the sections are the first bead's";
}

}  // namespace
}  // namespace weld_profiler
