// Pores and what passes for one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "weld/ideal_scan.h"
#include "weld/pits.h"
#include "weld_profiler/weld/weld_measurer.h"

namespace weld_profiler
{
TEST(Pits, APoreOfTwoMillimetresIsOneWithoutPiecesOfItsRim)
{
  const IdealWeld weld;
  for (const double x : { -0.0024, -0.0012, 0.0, 0.0022 })
  {
    const Pit pit{ x, 0.006, 0.002, 6e-4 };
    const WeldResult result =
        WeldMeasurer().measure(IdealScanner()([&](double px, double py) { return weld(px, py) - pit(px, py); }));
    SCOPED_TRACE(x);
    expectOnePore(result, pit, 5e-5);
    expectHeights(result, weld.height, 40);
  }
}

TEST(Pits, APoreIsFoundWhereManyPointsAreMissing)
{
  const IdealWeld weld;
  const Pit pit{ 0.0008, 0.006, 0.0014, 5e-4 };
  for (const double holes : { 0.2, 0.4 })
  {
    IdealScanner scanner;
    scanner.holes = holes;
    const WeldResult result =
        WeldMeasurer().measure(scanner([&](double x, double y) { return weld(x, y) - pit(x, y); }));
    ASSERT_EQ(result.spots.size(), 1u) << holes;
    EXPECT_EQ(result.spots.front().kind, WeldSpot::Kind::Pore);
  }
}

TEST(Pits, AmongLargeBallsNoneGoesIntoTheHeight)
{
  const IdealWeld weld;
  std::mt19937 generator(8);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<Eigen::Vector3d> balls;  // x, y, radius; what lies between two of them passes for a pit
  for (int i = 0; i < 60; ++i)
  {
    const double x = 0.014 * (uniform(generator) - 0.5), y = 0.02 * uniform(generator);
    balls.emplace_back(x, y, 3e-4 + 7e-4 * uniform(generator));
  }
  const auto surface = [&](double x, double y)
  {
    double z = weld(x, y);
    for (const Eigen::Vector3d& ball : balls)
    {
      const double left = ball.z() * ball.z() - (ball.head<2>() - Eigen::Vector2d(x, y)).squaredNorm();
      if (left > 0.0)
        z = std::max(z, weld(ball.x(), ball.y()) + std::sqrt(left));
    }
    return z;
  };
  IdealScanner scanner;
  scanner.rows = 100;
  expectHeights(WeldMeasurer().measure(scanner(surface)), weld.height, 5);
}

TEST(Pits, APoreOfThreeMillimetresBesideAToeMovesNeitherToeNorHeights)
{
  IdealWeld weld;
  weld.ripple = 1e-4;
  IdealScanner scanner;
  scanner.rows = 100;
  const Pit pit{ 0.0017, 0.010, 0.0032, 9e-4 };
  const auto surface = [&](double x, double y) { return weld(x, y) - pit(x, y); };
  const WeldResult result = WeldMeasurer().measure(scanner(surface));
  ASSERT_EQ(result.spots.size(), 1u);
  const WeldSpot& spot = result.spots.front();
  EXPECT_EQ(spot.kind, WeldSpot::Kind::Pore);
  EXPECT_NEAR(spot.diameter.value, pit.diameter, 2.0 * spot.diameter.sigma);
  EXPECT_LT(spot.diameter.sigma, 0.15 * pit.diameter);
  EXPECT_GT(result.measured_share, 0.9);
  for (const WeldSection& section : result.sections)
  {
    const double y = section.s + scanner.first_y;
    double crest = 0.0;
    for (double x = -0.003; x < 0.003; x += 1e-5)
      crest = std::max(crest, surface(x, y));
    const Quantity& height = section.height_left;
    EXPECT_TRUE(!height.measured() || std::abs(height.value - crest) < 5.0 * height.sigma)
        << "y " << y << ": " << height.value << " +- " << height.sigma << ", true " << crest;
  }
}

TEST(Pits, AWallThatFallsIntoAPitIsNoToe)
{
  IdealWeld weld;
  weld.height = 0.0012;
  weld.misalignment = 3e-4;
  IdealScanner scanner;
  scanner.rows = 150;
  scanner.pitch = 1.5e-4;
  const Pit pit{ 0.0018, 0.010, 0.0033, 9.6e-4 };
  const auto surface = [&](double x, double y) { return weld(x, y) - pit(x, y); };
  const WeldResult result = WeldMeasurer().measure(scanner(surface));
  ASSERT_EQ(result.spots.size(), 1u);
  EXPECT_NEAR(result.spots.front().diameter.value, pit.diameter, 2.0 * result.spots.front().diameter.sigma);
  EXPECT_GT(result.measured_share, 0.9);
  for (const WeldSection& section : result.sections)
  {
    double crest = 0.0;
    for (double x = -0.003; x < 0.003; x += 1e-5)
      crest = std::max(crest, surface(x, section.s) - weld.plate(-0.01));
    const Quantity& height = section.height_left;
    EXPECT_TRUE(!height.measured() || std::abs(height.value - crest) < 5.0 * height.sigma + 2e-6)
        << "s " << section.s << ": " << height.value << " +- " << height.sigma << ", true " << crest;
  }
}

TEST(Pits, AHollowHalfOfWhoseRimIsHiddenIsNoPore)
{
  const IdealWeld weld;
  const Pit pit{ -0.001, 0.006, 0.0008, 3e-4 };
  for (const bool hidden : { false, true })
  {
    const auto surface = [&](double x, double y)
    {
      const bool missing = hidden && x > pit.x && x < pit.x + 0.001 && std::abs(y - pit.y) < 0.001;
      return missing ? std::numeric_limits<double>::quiet_NaN() : weld(x, y) - pit(x, y);
    };
    const WeldResult result = WeldMeasurer().measure(IdealScanner()(surface));
    SCOPED_TRACE(hidden ? "hidden" : "seen");
    EXPECT_EQ(result.spots.size(), hidden ? 0u : 1u);
    expectHeights(result, weld.height, 40);
  }
}

TEST(Pits, AGapBetweenBallsIsNoPore)
{
  const IdealWeld weld;
  const Pit gap{ -0.001, 0.006, 0.0006, 2e-4 };
  const auto surface = [&](double x, double y)
  {
    double ball = 0.0;
    for (const double side : { -1.0, 1.0 })
    {
      const double r = std::hypot(x - gap.x - side * 0.0006, y - gap.y) / 0.0004;
      ball = std::max(ball, r < 1.0 ? 4e-4 * std::sqrt(1.0 - r * r) : 0.0);
    }
    return weld(x, y) + (ball > 0.0 ? ball : -gap(x, y));
  };
  const WeldResult result = WeldMeasurer().measure(IdealScanner()(surface));
  EXPECT_EQ(result.spots.size(), 2u);
  for (const WeldSpot& spot : result.spots)
    EXPECT_EQ(spot.kind, WeldSpot::Kind::Spatter);
}

TEST(Pits, AHoleDeeperThanLightReachesIsNoPore)
{
  const IdealWeld weld;
  for (const double depth : { 4e-4, 1.5e-3 })
  {
    const auto surface = [&](double x, double y)
    { return weld(x, y) - (std::hypot(x + 0.001, y - 0.006) < 2.5e-4 ? depth : 0.0); };
    const WeldResult result = WeldMeasurer().measure(IdealScanner()(surface));
    EXPECT_EQ(result.spots.size(), depth < 5e-4 ? 1u : 0u) << depth;
  }
}

TEST(Pits, WhatTheScansOwnOutliersMakeIsNoPoreForCertain)
{
  const IdealWeld weld;
  // points in a row that lie too low, as glints leave them: rows, first cell, how many
  struct Outlier
  {
    int row, rows, cell, cells;
  };
  const auto low = [](std::vector<Outlier> outliers)
  {
    return [outliers = std::move(outliers)](double x, double y)
    {
      const int row = static_cast<int>(std::lround(y / 2e-4)), cell = static_cast<int>(std::lround(x / 4.2e-5));
      const bool hit = std::any_of(
          outliers.begin(), outliers.end(),
          [&](const Outlier& one)
          { return row >= one.row && row < one.row + one.rows && cell >= one.cell && cell < one.cell + one.cells; });
      return IdealWeld()(x, y) - (hit ? 2.5e-4 : 0.0);
    };
  };
  const Outlier in_one_row{ 30, 1, 0, 9 }, in_three{ 30, 3, 0, 5 };
  struct Case
  {
    std::vector<Outlier> outliers;
    std::size_t pores, hollows;
  };
  const std::vector<Outlier> small{ { 10, 1, 20, 4 }, { 20, 1, -30, 5 }, { 45, 1, 40, 4 }, { 50, 1, -10, 5 } };
  std::vector<Outlier> with_small = small;
  with_small.push_back(in_three);
  for (const Case& one : { Case{ { in_one_row }, 0, 1 }, Case{ { in_three }, 1, 0 }, Case{ with_small, 0, 1 } })
  {
    const WeldResult result = WeldMeasurer().measure(IdealScanner()(low(one.outliers)));
    EXPECT_EQ(result.spots.size(), one.pores) << one.outliers.size();
    EXPECT_EQ(result.hollows.size(), one.hollows) << one.outliers.size();
  }
}
}  // namespace weld_profiler
