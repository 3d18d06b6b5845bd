// Where a bead ends and begins anew its face lies low without a pore; what is a pore there stays in doubt.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

#include "weld/ideal_scan.h"
#include "weld/judged.h"
#include "weld/pits.h"
#include "weld_profiler/weld/weld_evaluation.h"

namespace weld_profiler
{
namespace
{
/// Two tacks that leave a gap between round ends.
struct Restart
{
  IdealWeld weld;
  double gap = 1e-4, end_length = 5e-4;  ///< [m]
  double y = 0.0099;                     ///< the gap's middle [m]

  /// Of the bead's width and height.
  double share(double py) const
  {
    const double inside = std::abs(py - y) - 0.5 * gap;
    const double missing = 1.0 - std::clamp(inside / end_length, 0.0, 1.0);
    return std::sqrt(1.0 - missing * missing);
  }

  double operator()(double px, double py) const
  {
    const double f = std::max(1e-3, share(py));
    return weld.plate(px) + f * (weld(px / f, py) - weld.plate(px / f));
  }
};

Restart restart(double gap, double end_length)
{
  Restart tacks;
  tacks.weld.ripple = 5e-5;
  tacks.weld.misalignment = 3e-4;
  tacks.gap = gap, tacks.end_length = end_length;
  return tacks;
}

IdealScanner longScanner()
{
  IdealScanner scanner;
  scanner.rows = 110;
  return scanner;
}

Decision poreDecision(const WeldResult& result, QualityLevel level)
{
  const WeldVerdict verdict =
      WeldJudge(plate(8.0)).judge(WeldToJudge{ result.kind, &result.sections, &result.spots, &result.hollows });
  return rowOf(verdict, Imperfection::SurfacePore, level).decision;
}
std::vector<WeldSpot> poresOf(const WeldResult& result)
{
  std::vector<WeldSpot> pores;
  std::copy_if(result.spots.begin(), result.spots.end(), std::back_inserter(pores),
               [](const WeldSpot& spot) { return spot.kind == WeldSpot::Kind::Pore; });
  return pores;
}
}  // namespace

TEST(BeadEnds, TacksThatBeginAnewHaveNoPoreBetweenThem)
{
  for (const double gap : { 1e-4, 5e-4, 1e-3 })
  {
    for (const double end_length : { 3e-4, 5e-4, 1e-3 })
    {
      for (const double y : { 0.0099, 0.01, 0.0101 })
      {
        SCOPED_TRACE(std::to_string(1e3 * gap) + " mm, ends of " + std::to_string(1e3 * end_length) + " mm, at " +
                     std::to_string(1e3 * y) + " mm");
        Restart tacks = restart(gap, end_length);
        tacks.y = y;
        const WeldResult result = WeldMeasurer().measure(longScanner()(tacks));
        EXPECT_TRUE(poresOf(result).empty());
        EXPECT_TRUE(result.hollows.empty());
        EXPECT_GT(result.measured_share, 0.75);
      }
    }
  }
}

TEST(BeadEnds, WhatAllAcrossDoesBesideAnEndIsNoBall)
{
  const WeldResult result = WeldMeasurer().measure(longScanner()(restart(2e-3, 5e-4)));
  EXPECT_TRUE(result.spots.empty());
}

TEST(BeadEnds, APoreThatAnEndCutsLeavesThePoresUndecided)
{
  const Restart tacks = restart(1e-3, 1e-3);
  const Pit pit{ 0.0005, tacks.y - 0.5 * tacks.gap - 0.0008, 0.0016, 5e-4 };
  const WeldResult result =
      WeldMeasurer().measure(longScanner()([&](double x, double y) { return tacks(x, y) - pit(x, y); }));
  EXPECT_TRUE(poresOf(result).empty());
  EXPECT_EQ(result.hollows.size(), 1u);
  EXPECT_EQ(poreDecision(result, QualityLevel::B), Decision::Undecided);
}

TEST(BeadEnds, APoreClearOfAnEndIsOne)
{
  const Restart tacks = restart(1e-3, 1e-3);
  const Pit pit{ 0.0005, tacks.y - 0.5 * tacks.gap - 0.003, 0.0016, 5e-4 };
  const WeldResult result =
      WeldMeasurer().measure(longScanner()([&](double x, double y) { return tacks(x, y) - pit(x, y); }));
  const std::vector<WeldSpot> pores = poresOf(result);
  ASSERT_EQ(pores.size(), 1u);
  EXPECT_NEAR(pores.front().diameter.value, pit.diameter, 2.0 * pores.front().diameter.sigma);
  EXPECT_TRUE(result.hollows.empty());
  EXPECT_EQ(poreDecision(result, QualityLevel::B), Decision::Fail);
}

TEST(BeadEnds, AnObliqueCreaseWhoseBottomIsHiddenIsNoPore)
{
  IdealWeld weld;
  weld.yaw = 0.21;
  const auto creased = [&](double x, double y)
  {
    const double apart = std::abs(std::cos(weld.yaw) * y - std::sin(weld.yaw) * x - 0.010);
    const double rise = weld(x, y) - weld.plate(x);
    if (rise < 1e-5 || apart > 2e-4)
      return weld(x, y);
    return apart < 1.2e-4 ? std::numeric_limits<double>::quiet_NaN() : weld(x, y) - 0.4 * rise;
  };
  const WeldResult result = WeldMeasurer().measure(longScanner()(creased));
  EXPECT_TRUE(poresOf(result).empty());
  EXPECT_FALSE(result.hollows.empty());
}
}  // namespace weld_profiler
