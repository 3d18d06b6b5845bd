// Rippled beads where rows of the scan are far apart or missing: what the ripples do between them no point tells.
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "weld/ideal_scan.h"
#include "weld_profiler/weld/weld_measurer.h"

namespace weld_profiler
{
namespace
{
/// Low, oblique, between plates 0.6 mm offset: over the left plate it is highest well beside its middle.
IdealWeld rippledWeld(double yaw_deg)
{
  IdealWeld weld;
  weld.width = 0.010, weld.height = 6e-4, weld.misalignment = 6e-4;
  weld.ripple = 1e-4;
  weld.yaw = yaw_deg * M_PI / 180.0, weld.x = 0.003;
  return weld;
}

IdealScanner rowsApart(double pitch)
{
  IdealScanner scanner;
  scanner.pitch = pitch;
  scanner.rows = static_cast<int>(0.02 / pitch);
  return scanner;
}

/// Of a section between two toes, height over the left plate.
double trueHeight(const IdealWeld& weld, const WeldSection& section)
{
  const double x = 0.5 * (section.toe_left.x.value + section.toe_right.x.value);
  const double y = 0.5 * (section.toe_left.y.value + section.toe_right.y.value);
  const double across = std::cos(weld.yaw), along = std::sin(weld.yaw), half = 0.5 * weld.width;
  const double s = -along * (x - weld.x) + across * y;
  double highest = 0.0;
  for (double q = -half; q < half; q += 1e-5)
    highest = std::max(highest, weld(weld.x + across * q - along * s, along * q + across * s));
  return highest - weld.plate(-half);
}

/// Errors of the heights over the left plate, in sigmas.
struct Heights
{
  std::vector<double> errors;
  double largest_error = 0.0;  ///< [m]

  Heights(const IdealWeld& weld, const WeldResult& result)
  {
    for (const WeldSection& section : result.sections)
    {
      const Quantity& height = section.height_left;
      if (!height.measured() || !section.hasBead())
        continue;
      const double error = height.value - trueHeight(weld, section);
      largest_error = std::max(largest_error, std::abs(error));
      errors.push_back(error / height.sigma);
    }
  }

  double quadraticMean() const
  {
    double sum = 0.0;
    for (const double one : errors)
      sum += one * one / static_cast<double>(errors.size());
    return std::sqrt(sum);
  }
  double largest() const
  {
    double most = 0.0;
    for (const double one : errors)
      most = std::max(most, std::abs(one));
    return most;
  }
};

void dropRows(Scan& scan, std::size_t from, std::size_t count)
{
  for (std::size_t row = from; row < from + count; ++row)
    scan.rows[row].points.clear();
}
}  // namespace

TEST(MissingRows, HeightsOnRipplesBetweenThemAreAsUncertainAsTheyAreWrong)
{
  struct Case
  {
    double yaw_deg, share;
    unsigned seed;
  };
  // in the last the highest place that is told lies on a row, and a higher one between rows
  for (const Case& one : { Case{ 18.0, 0.3, 1 }, Case{ 18.0, 0.3, 2 }, Case{ 18.0, 0.3, 3 }, Case{ 12.0, 0.5, 4 } })
  {
    const IdealWeld weld = rippledWeld(one.yaw_deg);
    Scan scan = rowsApart(2e-4)(weld);
    std::mt19937 generator(one.seed);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (std::size_t row = 0; row < scan.rows.size(); ++row)
    {
      if (uniform(generator) < one.share)
        dropRows(scan, row, 1);
    }
    const Heights heights(weld, WeldMeasurer().measure(scan));
    ASSERT_GE(heights.errors.size(), 25u) << "seed " << one.seed;
    EXPECT_GT(heights.largest_error, 1.2e-5) << "seed " << one.seed << " would show nothing";
    EXPECT_LT(heights.quadraticMean(), 1.4) << "seed " << one.seed;
    EXPECT_LT(heights.largest(), 3.5) << "seed " << one.seed;
  }
}

TEST(MissingRows, NoHeightIsToldWhereTheCrestMayLieAmongThem)
{
  const IdealWeld weld = rippledWeld(12.0);
  const auto measure = [&](std::size_t first, std::size_t missing)
  {
    Scan scan = rowsApart(2e-4)(weld);
    for (const std::size_t row : { first, first + 20, first + 40 })
      dropRows(scan, row, missing);
    return Heights(weld, WeldMeasurer().measure(scan));
  };
  const Heights all = measure(28, 0);
  ASSERT_GE(all.errors.size(), 90u);
  for (std::size_t first = 28; first < 34; ++first)
  {
    const Heights some = measure(first, 3);
    ASSERT_GE(some.errors.size(), 45u) << "row " << first;
    EXPECT_LT(some.errors.size() + 25u, all.errors.size()) << "row " << first;
    EXPECT_LT(some.largest(), 3.0) << "row " << first << ": beside a break the face goes on unseen";
  }
}

TEST(MissingRows, RowsFarApartAreCountedInTheHeightsOfObliqueWelds)
{
  const IdealWeld weld = rippledWeld(25.0);
  for (const double pitch : { 2.5e-4, 4e-4 })
  {
    const Heights heights(weld, WeldMeasurer().measure(rowsApart(pitch)(weld)));
    ASSERT_GE(heights.errors.size(), 30u) << pitch;
    EXPECT_LT(heights.quadraticMean(), 1.7) << pitch;
    EXPECT_GT(heights.quadraticMean(), 0.5) << pitch << ": a sigma that is too large is not honest either";
    EXPECT_LT(heights.largest(), 4.0) << pitch;
  }
}

TEST(MissingRows, RippleHeightSaysWhatIsCutOffBetweenThem)
{
  const IdealWeld weld = rippledWeld(25.0);
  const WeldResult result = WeldMeasurer().measure(rowsApart(2.5e-4)(weld));
  ASSERT_TRUE(result.ripple_height.measured());
  EXPECT_LT(result.ripple_height.value, 0.95 * weld.ripple);
  EXPECT_NEAR(result.ripple_height.value, weld.ripple, 2.0 * result.ripple_height.sigma);
  EXPECT_LT(result.ripple_height.sigma, 0.3 * weld.ripple);
}
}  // namespace weld_profiler
