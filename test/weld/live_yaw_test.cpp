#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "weld_profiler/weld/live_yaw.h"

namespace weld_profiler
{
namespace
{
constexpr double kDegree = M_PI / 180.0;
constexpr double kPitch = 1e-4;  // [m]

/// Rows of a path; `bend` = curvature.
struct Path
{
  double x = 0.003, yaw = 0.0, bend = 0.0;

  double at(double y) const { return x - std::tan(yaw) * y + 0.5 * bend * y * y; }
  double yawAt(double y) const { return -std::atan(-std::tan(yaw) + bend * y); }
};

LiveYaw follow(const Path& path, int rows, double direction = 1.0)
{
  LiveYaw live;
  for (int row = 0; row < rows; ++row)
    live.add(path.at(direction * row * kPitch), direction * row * kPitch);
  return live;
}
}  // namespace

TEST(LiveYaw, KnowsNothingBeforeTheFirstRows)
{
  LiveYaw live;
  EXPECT_EQ(live.at(0.1).value, 0.0);
  EXPECT_DOUBLE_EQ(live.at(0.1).sigma, 0.35);
  live.add(0.001, 0.0);
  EXPECT_GT(live.at(kPitch).sigma, 0.3) << "one row tells nothing";
  live.add(0.001, kPitch);
  EXPECT_GT(live.at(2.0 * kPitch).sigma, 0.3) << "nor do two that are 0.1 mm apart";
}

TEST(LiveYaw, AStraightPathsYawAndSigmaAreThoseOfAParabolasEnd)
{
  const Path path{ 0.003, 12.0 * kDegree, 0.0 };
  for (const double direction : { 1.0, -1.0 })
  {
    const Quantity yaw = follow(path, 101, direction).at(direction * 100 * kPitch);
    // variance of a parabola's slope at its end: 192 sigma^2 / (n T^2); the middles' noise is the prior's, 0.1 mm
    // counted as 4 rows of 105, five neighbours err alike
    const double noise = 1e-4 * std::sqrt(4.0 / 105.0 * 5.0);
    const double sigma = std::sqrt(192.0 / 101.0) * noise / 0.01 * std::pow(std::cos(path.yaw), 2.0);
    EXPECT_NEAR(yaw.value, path.yaw, 0.1 * sigma);
    EXPECT_NEAR(yaw.sigma, sigma, 0.05 * sigma);
  }
}

TEST(LiveYaw, FollowsABend)
{
  const Path path{ 0.0, -6.0 * kDegree, 1.0 / 0.08 };
  const Quantity yaw = follow(path, 121).at(0.012);
  EXPECT_NEAR(yaw.value, path.yawAt(0.012), yaw.sigma);
  EXPECT_GT(std::abs(path.yawAt(0.012) - path.yawAt(0.006)), 5.0 * yaw.sigma) << "a straight line would not do";
}

TEST(LiveYaw, SigmasAreHonestFromTheFirstRowOn)
{
  std::mt19937 generator(7);
  std::normal_distribution<double> normal(0.0, 1.0);
  for (const int rows : { 3, 10, 30, 60, 120, 200 })
  {
    double squares = 0.0;
    constexpr int kPaths = 300;
    for (int i = 0; i < kPaths; ++i)
    {
      const Path path{ 0.0, std::atan(0.25 * normal(generator)), 5.0 * normal(generator) };
      LiveYaw live;
      double wander = 2e-5 * normal(generator);  // neighbours err alike over some 0.3 mm
      for (int row = 0; row < rows; ++row)
      {
        wander = 0.7 * wander + 2e-5 * std::sqrt(1.0 - 0.7 * 0.7) * normal(generator);
        live.add(path.at(row * kPitch) + wander, row * kPitch);
      }
      const Quantity yaw = live.at(rows * kPitch);
      squares += std::pow((yaw.value - path.yawAt(rows * kPitch)) / yaw.sigma, 2.0);
    }
    EXPECT_LT(std::sqrt(squares / kPaths), 1.3) << rows;
    EXPECT_GT(std::sqrt(squares / kPaths), 0.3) << rows;
  }
}

TEST(LiveYaw, RowsThatAreFarOffDoNotCount)
{
  const Path path{ 0.0, 10.0 * kDegree, 0.0 };
  LiveYaw live;
  for (int row = 0; row < 100; ++row)
    live.add(path.at(row * kPitch) + (row % 7 == 3 ? 0.0015 : 0.0), row * kPitch);
  live.add(NAN, 0.0101);
  live.add(0.0, INFINITY);
  const Quantity yaw = live.at(0.01);
  EXPECT_NEAR(yaw.value, path.yaw, 3.0 * yaw.sigma);
  EXPECT_LT(yaw.sigma, 1.0 * kDegree);
}

TEST(LiveYaw, AStageAtRestTellsNothingMore)
{
  LiveYaw live;
  std::mt19937 generator(3);
  std::normal_distribution<double> normal(0.0, 1e-6);
  for (int row = 0; row < 3000; ++row)
    live.add(0.001, normal(generator));
  EXPECT_GT(live.at(0.0).sigma, 0.3);
}

TEST(LiveYaw, ForgetsWhatWasBeforeAJumpAndWhenAskedTo)
{
  LiveYaw live = follow({ 0.0, 15.0 * kDegree, 0.0 }, 300);
  EXPECT_LT(live.at(0.03).sigma, 0.02);
  live.add(0.001, 0.0);  // the stage is back where it began
  EXPECT_GT(live.at(kPitch).sigma, 0.3);
  live = follow({ 0.0, 15.0 * kDegree, 0.0 }, 50);
  live.restart();
  EXPECT_EQ(live.at(0.005).value, 0.0);
  EXPECT_DOUBLE_EQ(live.at(0.005).sigma, 0.35);
}
}  // namespace weld_profiler
