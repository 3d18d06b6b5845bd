// Pores that are shallow and wide, and hollows that are not seen whole.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "weld/ideal_scan.h"
#include "weld/judged.h"
#include "weld/pits.h"
#include "weld_profiler/weld/weld_evaluation.h"

namespace weld_profiler
{
namespace
{
const VerdictRow& poreRow(const WeldResult& result, QualityLevel level)
{
  static WeldVerdict verdict;
  verdict = WeldJudge(plate(8.0)).judge(WeldToJudge{ result.kind, &result.sections, &result.spots, &result.hollows });
  return rowOf(verdict, Imperfection::SurfacePore, level);
}

IdealScanner longScanner()
{
  IdealScanner scanner;
  scanner.rows = 100;
  return scanner;
}

IdealWeld buttWeld()
{
  IdealWeld weld;
  weld.width = 0.010;
  weld.misalignment = 4e-4;
  return weld;
}
}  // namespace

TEST(Hollows, APoreATenthAsDeepAsItIsWideIsFoundAndGoesIntoNoHeight)
{
  const IdealWeld weld = buttWeld();
  for (const Pit& pit : { Pit{ 0.0, 0.010, 0.0028, 2.6e-4 }, Pit{ 0.0004, 0.0035, 0.0030, 3e-4 } })
  {
    SCOPED_TRACE(pit.y);
    const WeldResult result =
        WeldMeasurer().measure(longScanner()([&](double x, double y) { return weld(x, y) - pit(x, y); }));
    expectOnePore(result, pit, 3e-5);
    EXPECT_TRUE(result.hollows.empty());
    std::size_t told = 0;
    for (const WeldSection& section : result.sections)
    {
      told += section.reinforcement.measured() ? 1 : 0;
      EXPECT_TRUE(!section.reinforcement.measured() ||
                  std::abs(section.reinforcement.value - weld.height) < 5.0 * section.reinforcement.sigma)
          << "row " << section.row << ": " << section.reinforcement.value << " +- " << section.reinforcement.sigma;
    }
    EXPECT_GE(told, 70u);
    EXPECT_EQ(poreRow(result, QualityLevel::B).decision, Decision::Fail);
  }
}

TEST(Hollows, ALongWavesTroughIsNone)
{
  IdealWeld weld = buttWeld();
  const auto surface = [&](double x, double y)
  { return weld(x, y) + 3e-4 * std::max(0.0, 1.0 - x * x / 2.5e-5) * std::sin(2.0 * M_PI * y / 0.006); };
  IdealScanner scanner = longScanner();
  scanner.rows = 130;
  const WeldResult result = WeldMeasurer().measure(scanner(surface));
  EXPECT_TRUE(result.spots.empty());
  EXPECT_TRUE(result.hollows.empty());
  EXPECT_GT(std::count_if(result.sections.begin(), result.sections.end(),
                          [](const WeldSection& section) { return section.reinforcement.measured(); }),
            125);
}

TEST(Hollows, OneBetweenBallsLeavesThePoresUndecided)
{
  const IdealWeld weld = buttWeld();
  const Pit pit{ 0.001, 0.010, 0.0006, 2e-4 };
  for (const bool touched : { false, true })
  {
    SCOPED_TRACE(touched);
    const auto surface = [&](double x, double y)
    {
      double ball = 0.0;
      for (const double side : { -1.0, 1.0 })
      {
        const double r = std::hypot(x - pit.x - side * 0.0006, y - pit.y) / 0.0004;
        ball = std::max(ball, touched && r < 1.0 ? 4e-4 * std::sqrt(1.0 - r * r) : 0.0);
      }
      return weld(x, y) + (ball > 0.0 ? ball : -pit(x, y));
    };
    const WeldResult result = WeldMeasurer().measure(longScanner()(surface));
    ASSERT_EQ(result.hollows.size(), touched ? 1u : 0u);
    EXPECT_EQ(poreRow(result, QualityLevel::B).decision, touched ? Decision::Undecided : Decision::Fail);
    EXPECT_EQ(poreRow(result, QualityLevel::D).decision, Decision::Pass) << "twice as wide is permitted";
    EXPECT_TRUE(!touched || std::abs(result.hollows.front().s - poreRow(result, QualityLevel::B).s) < 1e-9);
  }
}

TEST(Hollows, ABeadThatIsNarrowerSomewhereHasNone)
{
  const IdealWeld weld = buttWeld();
  for (const double length : { 0.0005, 0.0008, 0.0012 })
  {
    SCOPED_TRACE(length);
    const auto waisted = [&](double x, double y)
    {
      const double d = (y - 0.010) / length, by = 0.08 * std::exp(-0.5 * d * d);
      return weld(x / (1.0 - by), y);
    };
    const WeldResult result = WeldMeasurer().measure(longScanner()(waisted));
    EXPECT_TRUE(result.spots.empty());
    EXPECT_TRUE(result.hollows.empty());
    EXPECT_EQ(poreRow(result, QualityLevel::B).decision, Decision::Pass);
  }
}

TEST(Hollows, OneAtAToeLeavesThePoresUndecided)
{
  const IdealWeld weld = buttWeld();
  const Pit pit{ 0.0046, 0.010, 0.0014, 4e-4 };
  const auto surface = [&](double x, double y) { return weld(x, y) - (x < 0.005 ? pit(x, y) : 0.0); };
  const WeldResult result = WeldMeasurer().measure(longScanner()(surface));
  EXPECT_TRUE(result.spots.empty());
  ASSERT_EQ(result.hollows.size(), 1u);
  EXPECT_EQ(poreRow(result, QualityLevel::B).decision, Decision::Undecided);
}
}  // namespace weld_profiler
