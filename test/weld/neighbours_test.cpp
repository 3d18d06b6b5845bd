// What stands beside a weld, and scans of a few rows.
#include <gtest/gtest.h>

#include "weld/ideal_scan.h"
#include "weld/row_beads.h"
#include "weld/scan_grid.h"
#include "weld_profiler/weld/weld_measurer.h"

namespace weld_profiler
{
namespace
{
/// 2.4 mm high and 8 mm wide, its right plate 0.4 mm higher.
IdealWeld offsetWeld()
{
  IdealWeld weld;
  weld.height = 0.0024;
  weld.misalignment = 0.0004;
  weld.x = -0.006;
  return weld;
}

void expectWidth(const WeldResult& result, double width, std::size_t at_least)
{
  std::size_t told = 0;
  for (const WeldSection& section : result.sections)
  {
    if (!section.hasBead())
      continue;
    ++told;
    EXPECT_NEAR(section.width.value, width, 5e-5) << "row " << section.row;
  }
  EXPECT_GE(told, at_least) << result.reason;
}

/// A weld that a second bead lies beside, 6 mm wide, on side -1 or 1 after a piece of bare plate.
struct TwoBeads
{
  double misalignment = 0.0, height = 0.001;
  double bare = 0.003;
  int side = 1;

  WeldResult measured() const
  {
    IdealWeld weld = offsetWeld();
    weld.misalignment = misalignment;
    weld.x = -side * 0.003;
    IdealWeld second;
    second.width = 0.006;
    second.height = height;
    second.x = weld.x + side * (0.5 * weld.width + bare + 0.5 * second.width);
    IdealScanner scanner;
    scanner.rows = 20;
    return WeldMeasurer().measure(
        scanner([&](double x, double y) { return weld(x, y) + std::max(0.0, second(x, y)); }));
  }
};
}  // namespace

TEST(Neighbours, TwoBeadsALittleApartAreNoOneWeld)
{
  for (const double misalignment : { -0.0004, 0.0, 0.0004 })
    for (const double height : { 0.0003, 0.001 })
      for (const int side : { -1, 1 })
        for (int tenths = 16; tenths <= 30; tenths += 2)
        {
          SCOPED_TRACE(testing::Message() << misalignment << " " << height << " " << side << " " << tenths);
          const WeldResult result = TwoBeads{ misalignment, height, 1e-4 * tenths, side }.measured();
          for (const WeldSection& section : result.sections)
            EXPECT_FALSE(section.width.value > 0.009) << section.width.value;
          EXPECT_EQ(result.other_beads.empty(), false) << result.reason;
        }
}

TEST(Neighbours, AShortPieceOfPlateBeforeABeadIsEnough)
{
  for (const double misalignment : { -0.0004, 0.0, 0.0004 })
    for (const int side : { -1, 1 })
      for (int tenths = 28; tenths <= 48; tenths += 2)
      {
        SCOPED_TRACE(testing::Message() << misalignment << " " << side << " " << tenths);
        const WeldResult result = TwoBeads{ misalignment, 0.001, 1e-4 * tenths, side }.measured();
        expectWidth(result, std::hypot(0.008, misalignment), 19);
        EXPECT_EQ(result.other_beads.size(), 1u);
      }
}

TEST(Neighbours, AClampAfterAShortPieceOfPlateIsPassedBy)
{
  IdealScanner scanner;
  scanner.rows = 40;
  scanner.noise = 1e-6;
  for (int tenths = 36; tenths <= 60; tenths += 2)
  {
    SCOPED_TRACE(tenths);
    const IdealWeld weld = offsetWeld();
    const double plate = weld.x + 0.5 * weld.width + 1e-4 * tenths;  // its shadow is 1 mm long, its top 9.5 mm wide
    const WeldResult result = WeldMeasurer().measure(scanner(
        [&](double x, double y) {
          return x < plate || x > plate + 0.0105 ? weld(x, y) : x < plate + 0.001 ? NAN : weld(x, y) + 0.005;
        }));
    expectWidth(result, std::hypot(0.008, weld.misalignment), 38);
  }
}

TEST(Neighbours, ACrestCutOffByTheFieldsEdgeIsNoParent)
{
  IdealScanner scanner;  // sees 21 mm to either side of its middle
  scanner.rows = 20;
  int whole = 0;
  for (const int side : { -1, 1 })
  {
    for (int tenths = 165; tenths <= 210; tenths += 5)
    {
      SCOPED_TRACE(side * tenths);
      IdealWeld weld;
      weld.width = 0.010;
      weld.x = side * 1e-4 * tenths;
      const weld::ScanGrid grid = weld::makeGrid(scanner(weld));
      for (int row = 0; row < scanner.rows; ++row)
      {
        for (const weld::RowBead& bead : weld::findRowBeads(grid, row, WeldParams()).beads)
          whole += bead.whole() ? 1 : 0;
      }
    }
  }
  EXPECT_EQ(whole, 0);
}

TEST(Neighbours, WhatIsSeenOtherwiseFromRowToRowIsNoWeld)
{
  IdealWeld weld;  // the field's edge cuts it off near its crest
  weld.width = 0.010;
  weld.height = 0.001;
  weld.misalignment = -0.0004;
  weld.x = -0.0149;
  IdealScanner scanner;
  scanner.rows = 20;
  scanner.noise = 2.5e-6;
  const WeldResult result = WeldMeasurer().measure(scanner(weld));
  EXPECT_FALSE(result.hasWeld());
  EXPECT_NE(result.reason, "");
}

TEST(Neighbours, BarePlateBetweenTwoBeadsPartsThem)
{
  const IdealWeld weld = offsetWeld();
  IdealWeld second;  // on the higher plate, 5 mm beside the toe
  second.width = 0.004;
  second.height = 0.0005;
  second.x = 0.005;
  const WeldResult result = WeldMeasurer().measure(
      IdealScanner()([&](double x, double y) { return weld(x, y) + std::max(0.0, second(x, y)); }));
  EXPECT_EQ(result.kind, WeldKind::Butt);
  expectWidth(result, 0.00801, 55);
  ASSERT_EQ(result.other_beads.size(), 1u);
  EXPECT_NEAR(result.other_beads[0].x, 0.005, 5e-4);
}

TEST(Neighbours, AClampNearTheToeHidesNoWeld)
{
  const IdealWeld weld = offsetWeld();
  const auto surface = [&](double x, double y)
  { return weld(x, y) + (x > 0.0025 ? 0.005 : 0.0); };  // 4.5 mm beside the toe, up to the field's edge
  expectWidth(WeldMeasurer().measure(IdealScanner()(surface)), 0.00801, 55);
}

TEST(Neighbours, APitInThePlateIsNoPore)
{
  const IdealWeld weld;
  const auto surface = [&](double x, double y)
  {
    const double pit = 0.0004 - std::hypot(x - 0.012, y - 0.006);
    return weld(x, y) - (pit > 0.0 ? 3e-4 : 0.0);
  };
  const WeldResult result = WeldMeasurer().measure(IdealScanner()(surface));
  expectWidth(result, 0.008, 55);
  EXPECT_TRUE(result.spots.empty());
}

TEST(FewRows, ThreeToTenAreEnough)
{
  for (const int rows : { 3, 5, 10 })
  {
    IdealScanner scanner;
    scanner.rows = rows;
    scanner.pitch = 1.5e-4;
    SCOPED_TRACE(rows);
    expectWidth(WeldMeasurer().measure(scanner(IdealWeld())), 0.008, static_cast<std::size_t>(rows) - 1);
  }
}

TEST(FewRows, TwoAreSaidToBeTooFew)
{
  IdealScanner scanner;
  scanner.rows = 2;
  const WeldResult result = WeldMeasurer().measure(scanner(IdealWeld()));
  EXPECT_FALSE(result.hasWeld());
  EXPECT_NE(result.reason.find("2 rows"), std::string::npos) << result.reason;
}

TEST(Undercut, OneNarrowerThanTheStripeCanShowSaysSo)
{
  IdealWeld weld;
  weld.undercut = 0.0002;
  IdealScanner scanner;
  scanner.pitch = 1e-3;  // rows 1 mm apart cross its rims obliquely
  scanner.rows = 20;
  weld.yaw = 0.35;
  int told = 0;
  for (const WeldSection& section : WeldMeasurer().measure(scanner(weld)).sections)
  {
    if (!section.undercut_right.measured())
      continue;
    ++told;
    EXPECT_NEAR(section.undercut_right.value, 0.0002, 4.0 * section.undercut_right.sigma) << "row " << section.row;
  }
  EXPECT_GE(told, 5);
}
}  // namespace weld_profiler
