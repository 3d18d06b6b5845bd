// Welds whose toes or crest are hard to tell.
#include <gtest/gtest.h>

#include "weld/ideal_scan.h"
#include "weld/undercut_flank.h"
#include "weld_profiler/weld/weld_measurer.h"

namespace weld_profiler
{
namespace
{
/// Sections with a bead; fails when there are fewer.
std::vector<WeldSection> sectionsOf(const WeldResult& result, std::size_t at_least)
{
  std::vector<WeldSection> sections;
  for (const WeldSection& section : result.sections)
  {
    if (section.hasBead())
      sections.push_back(section);
  }
  EXPECT_GE(sections.size(), at_least) << result.reason;
  return sections;
}

Quantity flankToeAt(const std::vector<Eigen::Vector2d>& outline, double toe)
{
  return weld::flankToe(outline, toe, 1e-6);
}
}  // namespace

TEST(HardWelds, ABallAmongRipplesIsNotTheCrest)
{
  IdealWeld weld;
  weld.ripple = 1.8e-4;
  const auto surface = [&weld](double x, double y)
  {
    const double rest = 6.25e-8 - (x - 0.0003) * (x - 0.0003) - (y - 0.006) * (y - 0.006);
    return weld(x, y) + (rest > 0.0 ? std::sqrt(rest) : 0.0);
  };
  const WeldResult result = WeldMeasurer().measure(IdealScanner()(surface));
  for (const WeldSection& section : sectionsOf(result, 58))
  {
    if (section.reinforcement.measured())
    {
      EXPECT_LT(section.reinforcement.value, 0.0015 + 0.9e-4 + 2e-5) << "row " << section.row;
    }
  }
  ASSERT_EQ(result.spots.size(), 1u);
  EXPECT_NEAR(result.spots[0].y, 0.006, 2e-4);
}

TEST(HardWelds, RipplesAreNoSpatterAtTheScansEnds)
{
  IdealWeld weld;
  weld.ripple = 2.5e-4;
  const WeldResult result = WeldMeasurer().measure(IdealScanner()(weld));
  EXPECT_TRUE(result.spots.empty());
  EXPECT_EQ(sectionsOf(result, 60).size(), 60u);
  for (int row = 0; row < 60; ++row)
  {
    EXPECT_EQ(result.labels[static_cast<std::size_t>(row) * 1000u + 500u], static_cast<std::uint8_t>(WeldLabel::Bead))
        << "row " << row;
  }
}

TEST(HardWelds, NoSpatterWhereABeadEndsRound)
{
  // an ellipse's quarter, 2 mm long, at either end
  const auto surface = [](double x, double y)
  {
    const double into = std::min(1.0, std::min(y - 0.001, 0.019 - y) / 0.002);
    if (into <= 0.0)
      return 0.0;
    const double share = std::sqrt(1.0 - (1.0 - into) * (1.0 - into)), half = 0.005 * share;
    return std::max(0.0, 0.002 * share * (1.0 - x * x / (half * half)));
  };
  for (const unsigned seed : { 1U, 2U, 3U })
  {
    IdealScanner scanner;
    scanner.rows = 80, scanner.pitch = 2.5e-4, scanner.seed = seed;
    const WeldResult result = WeldMeasurer().measure(scanner(surface));
    sectionsOf(result, 60);
    EXPECT_TRUE(result.spots.empty()) << result.spots.size() << " told, the first at y " << result.spots.front().y;
  }
}

TEST(HardWelds, AHollowFilletHasNoConvexity)
{
  const auto hollow = [](double x, double /*y*/)
  {
    const double half = 0.004, depth = 0.0006, radius = 0.5 * (half * half + depth * depth) / depth;
    return std::abs(x) >= half ? std::abs(x) : half + (radius - depth) - std::sqrt(radius * radius - x * x);
  };
  const WeldResult result = WeldMeasurer().measure(IdealScanner()(hollow));
  EXPECT_EQ(result.kind, WeldKind::Fillet);
  for (const WeldSection& section : sectionsOf(result, 60))
  {
    EXPECT_NEAR(section.width.value, 0.008, 3e-5);
    EXPECT_LT(section.reinforcement.value, 3.0 * section.reinforcement.sigma);
    EXPECT_LT(section.area.value, 0.0) << "the face lies below the chord";
  }
}

TEST(HardWelds, ALowFaceMayFallFromTheToeOfTheHigherPlate)
{
  IdealWeld weld;
  weld.width = 0.010;
  weld.height = 0.0003;
  weld.misalignment = 0.002;  // the face rises by 18 deg to the left toe and falls by 4 deg from the right plate
  const WeldResult result = WeldMeasurer().measure(IdealScanner()(weld));
  EXPECT_EQ(result.kind, WeldKind::Butt);
  for (const WeldSection& section : sectionsOf(result, 55))
  {
    EXPECT_NEAR(section.width.value, 0.010198, 2.5e-4) << "row " << section.row;
    EXPECT_NEAR(section.misalignment.value, 0.002, 1e-5);
  }
}

TEST(HardWelds, AFaceThatCrossesItsParentTwiceEndsAtTheOuterCrossing)
{
  IdealWeld weld;
  weld.width = 0.010;
  weld.height = 0.0003;
  weld.misalignment = 0.0009;  // from the right toe the face rises by 1.7 deg, and 2.5 mm inside dives below the parent
  const WeldResult result = WeldMeasurer().measure(IdealScanner()(weld));
  EXPECT_EQ(result.kind, WeldKind::Butt);
  ASSERT_GE(result.sections.size(), 55u);
  for (const WeldSection& section : result.sections)
  {
    if (section.hasBead())  // so flat a toe may be too uncertain
    {
      EXPECT_NEAR(section.width.value, 0.01004, 3.0 * section.width.sigma) << "row " << section.row;
    }
  }
  int bead = 0, right = 0;  // labels are told all the same
  for (std::size_t cell = 0; cell < result.cells; ++cell)
  {
    const std::size_t at = 30u * result.cells + cell;
    bead += result.labels[at] == static_cast<std::uint8_t>(WeldLabel::Bead) ? 1 : 0;
    right += result.labels[at] == static_cast<std::uint8_t>(WeldLabel::Base) ? 1 : 0;
  }
  EXPECT_GT(bead, 200);
  EXPECT_GT(right, 200);
}

TEST(HardWelds, AFlatFacesToeIsToldByItsUndercut)
{
  IdealWeld weld;
  weld.width = 0.006;
  weld.height = 0.00025;
  weld.undercut = 0.0003;
  for (const WeldSection& section : sectionsOf(WeldMeasurer().measure(IdealScanner()(weld)), 55))
  {
    EXPECT_NEAR(section.toe_right.x.value, 0.003, 8e-5) << "row " << section.row;
  }
}

TEST(FlankToe, IsWhereTheFlankMeetsTheParent)
{
  std::vector<Eigen::Vector2d> outline;
  for (double u = -0.003; u < 0.001; u += 4e-5)  // down to 0.2 mm at -0.5 mm, up at a slope of 0.4, flat from 0 on
    outline.emplace_back(u, u > 0.0 ? 0.0 : std::max(-2e-4, 0.4 * u) * (u > -0.0012 ? 1.0 : 0.0));
  const Quantity toe = flankToeAt(outline, 0.0001);
  ASSERT_TRUE(toe.measured());
  EXPECT_NEAR(toe.value, 0.0, 1e-6);
}

TEST(FlankToe, IsNotMeasuredWithoutAnUndercut)
{
  std::vector<Eigen::Vector2d> outline;
  for (double u = -0.003; u < 0.001; u += 4e-5)
    outline.emplace_back(u, std::max(0.0, 0.3 * u));
  EXPECT_FALSE(flankToeAt(outline, 0.0).measured());
}
}  // namespace weld_profiler
