// Scans that are not as a weld's should be: measured where possible, said where not, nothing made up.
#include <gtest/gtest.h>

#include "weld/ideal_scan.h"
#include "weld_profiler/weld/weld_measurer.h"

namespace weld_profiler
{
namespace
{
int beads(const WeldResult& result)
{
  int count = 0;
  for (const WeldSection& section : result.sections)
    count += section.hasBead() ? 1 : 0;
  return count;
}

/// Every section that has a bead has this width.
void expectWidth(const WeldResult& result, double width, double tolerance)
{
  for (const WeldSection& section : result.sections)
  {
    if (section.hasBead())
    {
      EXPECT_NEAR(section.width.value, width, tolerance) << "row " << section.row;
    }
  }
}

double plate(double /*x*/, double /*y*/)
{
  return 0.0;
}
}  // namespace

TEST(BadScans, NoPointsIsNoWeld)
{
  const WeldResult empty = WeldMeasurer().measure(Scan());
  EXPECT_FALSE(empty.hasWeld());
  EXPECT_NE(empty.reason.find("no measured points"), std::string::npos) << empty.reason;
  Scan holes = IdealScanner()(plate);
  for (Profile& row : holes.rows)
    row.points.clear();
  EXPECT_FALSE(WeldMeasurer().measure(holes).hasWeld());
  EXPECT_EQ(WeldMeasurer().measure(holes).labels.size(), 60000u);
}

TEST(BadScans, AnEmptyPlateIsNoWeld)
{
  const WeldResult result = WeldMeasurer().measure(IdealScanner()(plate));
  EXPECT_FALSE(result.hasWeld());
  EXPECT_TRUE(result.sections.empty());
  EXPECT_NE(result.reason.find("no bead"), std::string::npos) << result.reason;
}

TEST(BadScans, ABeadLowerThanItsNoiseIsNone)
{
  IdealWeld weld;
  weld.height = 0.00005;
  IdealScanner scanner;
  scanner.noise = 4e-5;
  EXPECT_EQ(beads(WeldMeasurer().measure(scanner(weld))), 0);
}

TEST(BadScans, OfTwoBeadsTheStrongerIsMeasuredTheOtherNamed)
{
  IdealWeld strong, weak;
  strong.x = -0.006, strong.height = 0.0015;
  weak.x = 0.009, weak.width = 0.005, weak.height = 0.0008;
  const auto both = [&](double x, double y) { return strong(x, y) + weak(x, y); };
  const WeldResult result = WeldMeasurer().measure(IdealScanner()(both));
  ASSERT_EQ(beads(result), 60);
  expectWidth(result, 0.008, 5e-5);
  EXPECT_NEAR(result.path[30].x, -0.006, 1e-4);
  ASSERT_EQ(result.other_beads.size(), 1u);
  EXPECT_NEAR(result.other_beads[0].x, 0.009, 3e-4);
  EXPECT_NEAR(result.other_beads[0].width, 0.005, 8e-4);
  EXPECT_NEAR(result.other_beads[0].height, 0.0008, 1e-4);
}

TEST(BadScans, ABeadAtTheEdgeHasNoWidth)
{
  IdealWeld weld;
  weld.x = 0.019;  // the field ends at 0.021
  const WeldResult result = WeldMeasurer().measure(IdealScanner()(weld));
  EXPECT_EQ(beads(result), 0);
  EXPECT_FALSE(result.reason.empty());
  for (const WeldSection& section : result.sections)
    EXPECT_FALSE(section.toe_right.x.measured());
}

TEST(BadScans, WithOneParentMissingNoWidthIsMadeUp)
{
  IdealWeld weld;
  weld.x = 0.0165;  // the right toe is 0.5 mm inside the field
  const WeldResult result = WeldMeasurer().measure(IdealScanner()(weld));
  EXPECT_EQ(beads(result), 0);
  EXPECT_FALSE(result.reason.empty());
}

TEST(BadScans, ThreeRowsAreEnough)
{
  IdealWeld weld;
  IdealScanner scanner;
  scanner.rows = 3;
  const WeldResult result = WeldMeasurer().measure(scanner(weld));
  ASSERT_EQ(beads(result), 3) << result.reason;
  expectWidth(result, 0.008, 1e-4);
  scanner.rows = 1;
  EXPECT_NO_THROW(WeldMeasurer().measure(scanner(weld)));
}

TEST(BadScans, SixtyPercentHolesAreMeasuredThrough)
{
  IdealScanner scanner;
  scanner.holes = 0.6;
  const WeldResult result = WeldMeasurer().measure(scanner(IdealWeld()));
  EXPECT_GE(beads(result), 57);
  expectWidth(result, 0.008, 6e-5);
}

TEST(BadScans, NothingIsGuessedAcrossABreakInTheFace)
{
  const IdealWeld weld;
  const auto broken = [&](double x, double y) { return x > -0.0045 && x < -0.0025 ? NAN : weld(x, y); };
  const WeldResult result = WeldMeasurer().measure(IdealScanner()(broken));
  EXPECT_EQ(beads(result), 0) << "the left toe lies in the break";
  const auto no_top = [&](double x, double y) { return std::abs(x) < 0.001 ? NAN : weld(x, y); };
  for (const WeldSection& section : WeldMeasurer().measure(IdealScanner()(no_top)).sections)
  {
    EXPECT_TRUE(section.hasBead());
    EXPECT_FALSE(section.reinforcement.measured()) << "the top was not seen";
    EXPECT_FALSE(section.area.measured());
  }
}

TEST(BadScans, AScanUpsideDownIsNoWeld)
{
  const IdealWeld weld;
  const auto flipped = [&](double x, double y) { return -weld(x, y); };
  const WeldResult result = WeldMeasurer().measure(IdealScanner()(flipped));
  EXPECT_FALSE(result.hasWeld());
  EXPECT_NE(result.reason.find("upside down"), std::string::npos) << result.reason;
}

TEST(BadScans, TackWeldsAreOneWeldWithBreaks)
{
  IdealWeld first, second;
  first.begin = 0.001, first.end = 0.007;
  second.begin = 0.013, second.end = 0.019;
  IdealScanner scanner;
  scanner.rows = 100;
  const auto tacks = [&](double x, double y) { return first(x, y) + second(x, y); };
  const WeldResult result = WeldMeasurer().measure(scanner(tacks));
  EXPECT_TRUE(result.other_beads.empty());
  int between = 0;
  for (const WeldSection& section : result.sections)
  {
    const double y = 2e-4 * section.row;
    const bool inside = (y > 0.0015 && y < 0.0065) || (y > 0.0135 && y < 0.0185);
    EXPECT_TRUE(!inside || section.hasBead()) << "y " << y;
    between += y > 0.0075 && y < 0.0125 && section.hasBead() ? 1 : 0;
  }
  EXPECT_EQ(between, 0);
  EXPECT_GE(beads(result), 50);
}

TEST(BadScans, AClampBesideTheWeldIsNoPartOfIt)
{
  const IdealWeld weld;
  const auto clamped = [&](double x, double y)
  { return weld(x, y) + (x > 0.011 && x < 0.017 && y > 0.003 && y < 0.009 ? 0.005 : 0.0); };
  const WeldResult result = WeldMeasurer().measure(IdealScanner()(clamped));
  ASSERT_EQ(result.kind, WeldKind::BeadOnPlate) << result.reason;
  EXPECT_GE(beads(result), 57);
  expectWidth(result, 0.008, 6e-5);
  const auto on_clamp = static_cast<WeldLabel>(result.labels[30u * 1000u + 830u]);
  EXPECT_EQ(on_clamp, WeldLabel::Unknown);
}

TEST(BadScans, ABlockAloneIsNoWeld)
{
  const auto block = [](double x, double /*y*/) { return std::abs(x) < 0.005 ? 0.003 : 0.0; };
  const WeldResult result = WeldMeasurer().measure(IdealScanner()(block));
  EXPECT_FALSE(result.hasWeld());
  EXPECT_NE(result.reason.find("upright walls"), std::string::npos) << result.reason;
}

TEST(BadScans, APyramidIsNoWeld)
{
  IdealScanner scanner;
  scanner.rows = 120;
  const auto pyramid = [](double x, double y)
  { return std::max(0.0, 0.006 - std::max(std::abs(x), std::abs(y - 0.012)) * 0.7); };
  const WeldResult result = WeldMeasurer().measure(scanner(pyramid));
  EXPECT_FALSE(result.hasWeld());
  EXPECT_EQ(beads(result), 0);
  EXPECT_FALSE(result.reason.empty());
}

TEST(BadScans, ACraterIsInsideTheBead)
{
  const IdealWeld weld;
  const auto cratered = [&](double x, double y)
  {
    const double far = std::hypot(x, y - 0.006) / 0.002;
    return weld(x, y) - (far < 1.0 ? 0.0008 * std::pow(std::cos(0.5 * M_PI * far), 2.0) : 0.0);
  };
  const WeldResult result = WeldMeasurer().measure(IdealScanner()(cratered));
  EXPECT_EQ(beads(result), 60);
  expectWidth(result, 0.008, 6e-5);
  EXPECT_EQ(result.labels[30u * 1000u + 500u], static_cast<std::uint8_t>(WeldLabel::Bead));
}
}  // namespace weld_profiler
