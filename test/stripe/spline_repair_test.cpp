#include "stripe/spline_repair.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "support/extract.h"

namespace weld_profiler
{
namespace
{
/// A line of centres with noise, some cells left out.
Stripe line(const std::function<double(double)>& row, const std::function<bool(int)>& missing, double noise = 0.01)
{
  std::mt19937 random(4);
  std::normal_distribution<double> scatter(0.0, noise);
  Stripe stripe;
  stripe.status = StripeStatus::Ok;
  for (int cell = 0; cell < 200; ++cell)
  {
    StripePoint point;
    point.cell = static_cast<std::uint16_t>(cell);
    point.u = static_cast<float>(cell);
    point.v = static_cast<float>(row(cell) + scatter(random));
    point.sigma = static_cast<float>(noise);
    point.width = 2.0F;
    point.intensity = 200.0F;
    if (!missing(cell))
      stripe.push_back(point);
  }
  return stripe;
}

RepairSettings settings()
{
  RepairSettings repair;
  repair.first_cell = 0;
  repair.last_cell = 199;
  return repair;
}

double bead(double u)
{
  return 80.0 - 20.0 * std::exp(-0.5 * std::pow((u - 100.0) / 26.0, 2.0));
}

TEST(SplineRepair, FillsABreakFlagsItAndGrowsItsSigma)
{
  Stripe stripe = line(bead, [](int cell) { return cell > 60 && cell <= 70; });
  const std::size_t before = stripe.size();
  Stripe memory;
  repairGaps(settings(), stripe, memory);
  ASSERT_EQ(stripe.size(), before + 10);
  for (std::size_t i = 0; i < stripe.size(); ++i)
  {
    ASSERT_EQ(stripe.cell[i], i);
    const bool filled = stripe.cell[i] > 60 && stripe.cell[i] <= 70;
    EXPECT_EQ((stripe.flags[i] & stripe_flag::kInterpolated) != 0, filled) << "cell " << i;
    if (filled)
    {
      EXPECT_GT(stripe.sigma[i], 0.01F);
      EXPECT_NEAR(stripe.v[i], bead(stripe.u[i]), 3.0 * stripe.sigma[i]) << "cell " << i;
      EXPECT_NEAR(stripe.width[i], 2.0, 1e-6);
    }
  }
  EXPECT_GT(stripe.sigma[65], stripe.sigma[61]) << "it grows toward the middle";
  const double slope = (bead(65.1) - bead(64.9)) / 0.2;
  EXPECT_NEAR(stripe.normal_angle[65], std::atan2(1.0, -slope), 0.03);
}

TEST(SplineRepair, FillsABreakOfOneAndOfTheLongestAllowed)
{
  for (const int length : { 1, 2, 5, 20 })
  {
    Stripe stripe = line(bead, [=](int cell) { return cell > 30 && cell <= 30 + length; });
    Stripe memory;
    repairGaps(settings(), stripe, memory);
    EXPECT_EQ(stripe.size(), 200U) << length;
  }
}

TEST(SplineRepair, LeavesALongerBreakOpen)
{
  Stripe stripe = line(bead, [](int cell) { return cell > 30 && cell <= 51; });
  Stripe memory;
  repairGaps(settings(), stripe, memory);
  EXPECT_EQ(stripe.size(), 179U);
  RepairSettings none = settings();
  none.max_gap_px = 0;
  stripe = line(bead, [](int cell) { return cell == 31; });
  repairGaps(none, stripe, memory);
  EXPECT_EQ(stripe.size(), 199U);
}

TEST(SplineRepair, NeverBridgesAStep)
{
  for (const double height : { 3.0, 8.0, 60.0 })
    for (const int length : { 1, 5, 15, 20 })
    {
      Stripe stripe = line([=](double u) { return u < 100.0 ? 80.0 : 80.0 + height; },
                           [=](int cell) { return cell >= 100 && cell < 100 + length; });
      Stripe memory;
      repairGaps(settings(), stripe, memory);
      EXPECT_EQ(stripe.size(), static_cast<std::size_t>(200 - length)) << "step of " << height << " px";
    }
}

TEST(SplineRepair, NeverBridgesAStepOfASpeckledLine)
{
  // A scatter of half a pixel hides the step from the residuals of a cubic: the straight continuations tell it.
  for (const double height : { 6.0, 10.0 })
    for (const int length : { 5, 15 })
    {
      Stripe stripe = line([=](double u) { return u < 100.0 ? 80.0 : 80.0 + height; },
                           [=](int cell) { return cell >= 100 && cell < 100 + length; }, 0.5);
      Stripe memory;
      repairGaps(settings(), stripe, memory);
      EXPECT_EQ(stripe.size(), static_cast<std::size_t>(200 - length)) << "step of " << height << " px";
    }
}

TEST(SplineRepair, NeverBridgesAnEdge)
{
  // The toe of a fillet, 45 deg against 0, with a break over it: nobody knows where the corner is.
  Stripe stripe =
      line([](double u) { return 80.0 + std::max(0.0, u - 100.0); }, [](int cell) { return cell >= 92 && cell < 108; });
  Stripe memory;
  repairGaps(settings(), stripe, memory);
  EXPECT_EQ(stripe.size(), 184U);
}

TEST(SplineRepair, StaysAwayFromTheImagesEdges)
{
  Stripe stripe = line(bead, [](int cell) { return cell == 5 || cell == 6; });
  Stripe memory;
  RepairSettings repair = settings();
  repair.edge_trim_px = 6;
  repairGaps(repair, stripe, memory);
  ASSERT_EQ(stripe.size(), 199U) << "cell 6 is filled, cell 5 is too close to the edge";
  EXPECT_EQ(stripe.cell[5], 6);
  Stripe ends = line(bead, [](int cell) { return cell < 10 || cell > 190; });
  repairGaps(settings(), ends, memory);
  EXPECT_EQ(ends.size(), 181U) << "nothing is extrapolated";
}

TEST(SplineRepair, ByLeastSquaresIsBetterThanAnInterpolatingSpline)
{
  const auto missing = [](int cell) { return cell % 50 > 20 && cell % 50 <= 30; };
  double squares[2] = { 0.0, 0.0 };
  for (const bool interpolating : { false, true })
  {
    Stripe stripe = line(bead, missing, 0.025);
    RepairSettings repair = settings();
    repair.interpolating = interpolating;
    Stripe memory;
    repairGaps(repair, stripe, memory);
    ASSERT_EQ(stripe.size(), 200U);
    for (std::size_t i = 0; i < stripe.size(); ++i)
      if ((stripe.flags[i] & stripe_flag::kInterpolated) != 0)
        squares[interpolating ? 1 : 0] += std::pow(stripe.v[i] - bead(stripe.u[i]), 2.0);
  }
  EXPECT_LT(squares[0], 0.5 * squares[1]);
}

TEST(SplineRepair, FillsOnlyTheCellsOfACoarserGrid)
{
  Stripe stripe = line(bead, [](int cell) { return cell % 2 == 1 || (cell > 60 && cell <= 70); });
  Stripe memory;
  RepairSettings repair = settings();
  repair.pitch = 2;
  repairGaps(repair, stripe, memory);
  ASSERT_EQ(stripe.size(), 100U);
  for (std::size_t i = 0; i < stripe.size(); ++i)
    EXPECT_EQ(stripe.cell[i], 2 * i);
}
}  // namespace
}  // namespace weld_profiler
