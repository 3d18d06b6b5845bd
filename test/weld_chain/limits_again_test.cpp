#include <gtest/gtest.h>

#include "weld/limits_again.h"

namespace weld_profiler
{
namespace weld_accuracy
{
namespace
{
constexpr double kMm = 1e-3;
constexpr double kDegree = 3.141592653589793 / 180.0;

std::array<Deviation, kSizes> flawless(double width, double height)
{
  std::array<Deviation, kSizes> sizes;
  for (Deviation& size : sizes)
    size = Deviation{ 0.0, 1e-6, 0.0 };
  sizes[Width].truth = width;
  for (const Size which : { Reinforcement, HeightLeft, HeightRight })
    sizes[which].truth = height;
  sizes[ToeAngleLeft].truth = sizes[ToeAngleRight].truth = 160.0 * kDegree;
  return sizes;
}

TEST(LimitsAgain, HeightsOfA12MmWeldAreThoseOfTheStandardsFormula)
{
  const Judging butt{ "butt", 10.0 * kMm, false };
  EXPECT_EQ(trueVerdict(butt, flawless(12.0 * kMm, 2.19 * kMm)), "B");
  EXPECT_EQ(trueVerdict(butt, flawless(12.0 * kMm, 2.21 * kMm)), "C");
  EXPECT_EQ(trueVerdict(butt, flawless(12.0 * kMm, 2.81 * kMm)), "D");
  EXPECT_EQ(trueVerdict(butt, flawless(12.0 * kMm, 4.01 * kMm)), "fail");
}

TEST(LimitsAgain, CapsBindForWideWelds)
{
  EXPECT_EQ(trueVerdict({ "butt", 10.0 * kMm, false }, flawless(50.0 * kMm, 4.99 * kMm)), "B");
  EXPECT_EQ(trueVerdict({ "butt", 10.0 * kMm, false }, flawless(50.0 * kMm, 5.01 * kMm)), "C");
  EXPECT_EQ(trueVerdict({ "fillet", 10.0 * kMm, false }, flawless(50.0 * kMm, 3.01 * kMm)), "C");
}

TEST(LimitsAgain, AnUndercutAMisalignmentOrASteepToeLowersTheLevel)
{
  const Judging judging{ "butt", 4.0 * kMm, true };
  auto sizes = flawless(12.0 * kMm, kMm);
  EXPECT_EQ(trueVerdict(judging, sizes), "B");
  sizes[UndercutRight].truth = 0.21 * kMm;
  EXPECT_EQ(trueVerdict(judging, sizes), "C");
  sizes[Misalignment].truth = 0.61 * kMm;
  EXPECT_EQ(trueVerdict(judging, sizes), "D");
  sizes[ToeAngleLeft].truth = 89.0 * kDegree;
  EXPECT_EQ(trueVerdict(judging, sizes), "fail");
  EXPECT_EQ(trueVerdict({ "butt", 4.0 * kMm, false }, sizes), "D") << "the toe angle was not asked for";
}

TEST(LimitsAgain, OnAThinPlateLevelBKnowsNoUndercut)
{
  auto sizes = flawless(6.0 * kMm, 0.5 * kMm);
  sizes[UndercutLeft].truth = 0.04 * kMm;
  EXPECT_EQ(trueVerdict({ "bead_on_plate", 2.0 * kMm, false }, sizes), "B") << "too small to count";
  sizes[UndercutLeft].truth = 0.06 * kMm;
  EXPECT_EQ(trueVerdict({ "bead_on_plate", 2.0 * kMm, false }, sizes), "C");
}

TEST(LimitsAgain, ClearMeansFourSigmaFromEveryLimitAndMeasured)
{
  const Judging judging{ "butt", 10.0 * kMm, false };
  auto sizes = flawless(12.0 * kMm, 2.15 * kMm);
  sizes[Reinforcement].sigma = sizes[HeightLeft].sigma = sizes[HeightRight].sigma = 0.01 * kMm;
  EXPECT_GT(clearanceOf(judging, sizes), 4.0);
  sizes[Width].sigma = 0.1 * kMm;  // a tenth of it is the limit's
  EXPECT_LT(clearanceOf(judging, sizes), 4.0);
  sizes[Width].sigma = 1e-6;
  EXPECT_GT(clearanceOf(judging, sizes), 4.0);
  sizes[UndercutLeft].sigma = kNaN;
  EXPECT_LT(clearanceOf(judging, sizes), 4.0);
}
}  // namespace
}  // namespace weld_accuracy
}  // namespace weld_profiler
