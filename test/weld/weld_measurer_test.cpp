#include "weld_profiler/weld/weld_measurer.h"

#include <gtest/gtest.h>
#include <Eigen/Core>

#include "weld/ideal_scan.h"
#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
namespace
{
constexpr double kDegree = M_PI / 180.0;

/// Middle section with a bead, or fails.
WeldSection middleSection(const WeldResult& result)
{
  EXPECT_TRUE(result.hasWeld()) << result.reason;
  for (std::size_t k = result.sections.size() / 2; k < result.sections.size(); ++k)
  {
    if (result.sections[k].hasBead())
      return result.sections[k];
  }
  ADD_FAILURE() << "no section with a bead in the scan's second half: " << result.reason;
  return WeldSection();
}

/// Value within 4 of its own sigmas and within a tolerance of the truth.
void expectMeasured(const char* what, const Quantity& quantity, double truth, double tolerance)
{
  ASSERT_TRUE(quantity.measured()) << what;
  EXPECT_NEAR(quantity.value, truth, tolerance) << what;
  EXPECT_LT(std::abs(quantity.value - truth), 4.0 * quantity.sigma) << what << ", sigma " << quantity.sigma;
}
}  // namespace

TEST(WeldMeasurer, SaysWhetherABeadRunsOutOfTheScan)
{
  IdealWeld weld;
  EXPECT_TRUE(WeldMeasurer().measure(IdealScanner()(weld)).runs_out);
  weld.begin = 0.003;
  EXPECT_TRUE(WeldMeasurer().measure(IdealScanner()(weld)).runs_out);
  weld.end = 0.009;
  EXPECT_FALSE(WeldMeasurer().measure(IdealScanner()(weld)).runs_out);
}

TEST(WeldMeasurer, MeasuresABeadOnPlate)
{
  IdealWeld weld;
  const WeldResult result = WeldMeasurer().measure(IdealScanner()(weld));
  EXPECT_EQ(result.kind, WeldKind::BeadOnPlate);
  ASSERT_EQ(result.sections.size(), 60u);
  EXPECT_DOUBLE_EQ(result.measured_share, 1.0);
  const WeldSection section = middleSection(result);
  // what 2 um of noise, alike over 5 neighbours, leaves: a few um in height, that over the flank's tangent in width
  expectMeasured("width", section.width, 0.008, 2e-5);
  expectMeasured("reinforcement", section.reinforcement, 0.0015, 6e-6);
  expectMeasured("height_left", section.height_left, 0.0015, 6e-6);
  EXPECT_LT(section.misalignment.value, 5e-6);
  EXPECT_LT(section.undercut_left.value, 1e-5);
  const double flank = 2.0 * std::atan(0.0015 / 0.004);
  EXPECT_GT(section.toe_angle_left.value, M_PI - flank) << "the face bends inward of the toe";
  EXPECT_NEAR(section.toe_angle_left.value, section.toe_angle_right.value, 2.0 * kDegree);
}

TEST(WeldMeasurer, MeasuresAButtWeldWithOffsetAngleAndUndercut)
{
  IdealWeld weld;
  weld.misalignment = 0.0004;
  weld.angle = 2.0 * kDegree;
  weld.undercut = 0.0003;
  const WeldResult result = WeldMeasurer().measure(IdealScanner()(weld));
  EXPECT_EQ(result.kind, WeldKind::Butt);
  const WeldSection section = middleSection(result);
  expectMeasured("width", section.width, std::hypot(0.008, 0.0004), 2e-5);
  expectMeasured("misalignment", section.misalignment, 0.0004 * std::cos(weld.angle), 6e-6);
  expectMeasured("angle", section.angle, weld.angle, 0.05 * kDegree);
  expectMeasured("undercut_right", section.undercut_right, 0.0003, 1.2e-5);
  EXPECT_LT(section.undercut_left.value, 1e-5);
}

TEST(WeldMeasurer, MeasuresTheLegsAndThroatOfAFillet)
{
  IdealWeld weld;
  weld.angle = 90.0 * kDegree;
  weld.height = 0.0006;
  const WeldResult result = WeldMeasurer().measure(IdealScanner()(weld));
  EXPECT_EQ(result.kind, WeldKind::Fillet);
  const WeldSection section = middleSection(result);
  expectMeasured("leg_left", section.leg_left, 0.008 * std::sqrt(0.5), 2e-5);
  expectMeasured("leg_right", section.leg_right, 0.008 * std::sqrt(0.5), 2e-5);
  expectMeasured("throat", section.throat, 0.004, 2e-5);
  expectMeasured("convexity", section.reinforcement, 0.0006, 6e-6);
  EXPECT_FALSE(section.misalignment.measured()) << "plates in a corner have none";
}

TEST(WeldMeasurer, TellsHowUncertainAFlatFilletsHeightIsByTheToeFarFromThePlate)
{
  IdealWeld weld;
  weld.angle = 90.0 * kDegree;
  weld.height = 0.0002;
  const WeldSection section = middleSection(WeldMeasurer().measure(IdealScanner()(weld)));
  // it is highest above one plate at the toe on the other, which stands upright on it
  expectMeasured("height_left", section.height_left, 0.008 * std::sqrt(0.5), 2e-5);
  expectMeasured("height_right", section.height_right, 0.008 * std::sqrt(0.5), 2e-5);
  const double tilt = std::cos(0.5 * weld.angle);
  EXPECT_GT(section.height_left.sigma, 0.95 * section.toe_right.x.sigma / tilt);
  EXPECT_GT(section.height_right.sigma, 0.95 * section.toe_left.x.sigma / tilt);
}

TEST(WeldMeasurer, FindsAnObliquePathAndCutsAcrossIt)
{
  IdealWeld weld;
  weld.yaw = 18.0 * kDegree;
  const WeldResult result = WeldMeasurer().measure(IdealScanner()(weld));
  const WeldSection section = middleSection(result);
  EXPECT_NEAR(section.yaw, weld.yaw, 0.3 * kDegree);
  expectMeasured("width", section.width, 0.008, 2.5e-5);
  EXPECT_NEAR(section.toe_right.x.value - section.toe_left.x.value, 0.008 * std::cos(weld.yaw), 6e-5);
  EXPECT_NEAR(section.toe_right.y.value - section.toe_left.y.value, 0.008 * std::sin(weld.yaw), 6e-5);
}

TEST(WeldMeasurer, TellsRipples)
{
  IdealWeld weld;
  weld.ripple = 1e-4;
  IdealScanner scanner;
  scanner.rows = 100;
  const WeldResult result = WeldMeasurer().measure(scanner(weld));
  EXPECT_NEAR(result.ripple_pitch.value, 0.0012, 2e-5);
  EXPECT_NEAR(result.ripple_height.value, 1e-4, 1e-5);
  EXPECT_FALSE(WeldMeasurer().measure(scanner(IdealWeld())).ripple_pitch.measured()) << "a smooth bead has none";
}

TEST(WeldMeasurer, MeasuresOneRowProvisionally)
{
  IdealWeld weld;
  weld.yaw = 15.0 * kDegree;
  const Scan scan = IdealScanner()(weld);
  const WeldSection section = WeldMeasurer().measureRow(scan.rows[30], { weld.yaw, 0.0 });
  ASSERT_TRUE(section.hasBead());
  EXPECT_NEAR(section.width.value, 0.008, 5e-5);
  EXPECT_NEAR(section.reinforcement.value, 0.0015, 1e-5);
  EXPECT_DOUBLE_EQ(section.stage, scan.rows[30].stage);
  IdealWeld none;
  none.width = 0.0;
  EXPECT_FALSE(WeldMeasurer().measureRow(IdealScanner()(none).rows[3]).hasBead());
}

TEST(WeldMeasurer, SaysTheSameHoweverRowsAndCellsAreOrdered)
{
  IdealWeld weld;
  weld.misalignment = 0.0003;
  weld.yaw = 5.0 * kDegree;
  const Scan scan = IdealScanner()(weld);
  Scan turned = scan;
  std::reverse(turned.rows.begin(), turned.rows.end());
  for (Profile& row : turned.rows)
  {
    std::reverse(row.points.begin(), row.points.end());
    for (CloudPoint& point : row.points)
      point.cell = static_cast<std::uint16_t>(scan.cells - 1 - point.cell);
  }
  const WeldResult a = WeldMeasurer().measure(scan), b = WeldMeasurer().measure(turned);
  ASSERT_EQ(a.sections.size(), b.sections.size());
  ASSERT_EQ(a.sections.size(), 60u);
  for (std::size_t k = 0; k < a.sections.size(); ++k)
  {
    ASSERT_EQ(a.sections[k].hasBead(), b.sections[k].hasBead());
    if (a.sections[k].hasBead())
    {
      EXPECT_DOUBLE_EQ(a.sections[k].width.value, b.sections[k].width.value);
    }
    EXPECT_EQ(a.sections[k].row, 59 - b.sections[k].row);
  }
  EXPECT_EQ(a.labels[10u * 1000u + 480u], b.labels[49u * 1000u + 519u]);
}

/// What is said of a weld that is measured as the kind that was asked for.
std::string saidOf(const IdealWeld& weld, WeldKind kind)
{
  WeldParams params;
  params.kind = name(kind);
  const WeldResult result = WeldMeasurer(params).measure(IdealScanner()(weld));
  EXPECT_EQ(result.kind, kind);
  EXPECT_DOUBLE_EQ(result.measured_share, 1.0);
  return result.reason;
}

TEST(WeldMeasurer, MeasuresFlushPlatesAsAButtWeldWhereThatIsAskedFor)
{
  EXPECT_EQ(saidOf(IdealWeld(), WeldKind::Butt), "") << "two plates without offset and angle look like one";
  WeldParams params;
  params.kind = "butt";
  const WeldResult result = WeldMeasurer(params).measure(IdealScanner()(IdealWeld()));
  EXPECT_EQ(result.scores.front().kind, WeldKind::Butt);
  EXPECT_LT(middleSection(result).misalignment.value, 5e-6);
  IdealWeld offset;
  offset.misalignment = 0.0004;
  EXPECT_EQ(saidOf(offset, WeldKind::Butt), "");
}

TEST(WeldMeasurer, SaysThatTheParentsDoNotLieAsInTheKindThatIsAskedFor)
{
  IdealWeld corner;
  corner.angle = 90.0 * kDegree;
  EXPECT_NE(saidOf(corner, WeldKind::Butt).find("weld of kind butt, which was asked for"), std::string::npos);
  EXPECT_NE(saidOf(IdealWeld(), WeldKind::Fillet).find("kind fillet, which was asked for"), std::string::npos);
  IdealWeld plate;
  plate.misalignment = 1e-5;
  EXPECT_EQ(saidOf(plate, WeldKind::BeadOnPlate), "") << "less than same_plate_offset";
  for (const double offset : { 4e-5, 0.0005 })
  {
    plate.misalignment = offset;
    EXPECT_NE(saidOf(plate, WeldKind::BeadOnPlate).find("kind bead_on_plate, which was asked for"), std::string::npos)
        << "507 is not judged of one plate, so that it must be said, offset " << offset;
  }
}

TEST(WeldMeasurer, TellsNoLegsOfPlatesThatMeetNowhere)
{
  WeldParams params;
  params.kind = "fillet";
  const WeldResult result = WeldMeasurer(params).measure(IdealScanner()(IdealWeld()));
  ASSERT_EQ(result.sections.size(), 60u);
  for (const WeldSection& section : result.sections)
    EXPECT_FALSE(section.leg_left.measured() || section.leg_right.measured() || section.throat.measured());
}

TEST(WeldMeasurer, RefusesACellOutsideTheScan)
{
  Scan scan = IdealScanner()(IdealWeld());
  scan.rows[3].points[5].cell = 1000;
  EXPECT_THROW(WeldMeasurer().measure(scan), PreconditionError);
}
}  // namespace weld_profiler
