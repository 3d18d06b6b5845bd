#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "weld/ideal_scan.h"
#include "weld_profiler/weld/weld_measurer.h"

using namespace weld_profiler;

TEST(MissingPieces, TellsNoHeightWhereTheCrestIsMissingInAPore)
{
  const IdealWeld weld;
  const auto surface = [&weld](double x, double y)
  {
    const double deep = 1.0 - Eigen::Vector2d(x - 0.0002, y - 0.006).squaredNorm() / (0.0009 * 0.0009);
    return weld(x, y) - 0.0004 * std::sqrt(std::max(0.0, deep));
  };
  const WeldResult result = WeldMeasurer().measure(IdealScanner()(surface));
  ASSERT_EQ(result.spots.size(), 1u);
  EXPECT_EQ(result.spots.front().kind, WeldSpot::Kind::Pore);
  int told = 0, hidden = 0;
  for (const WeldSection& section : result.sections)
  {
    const Quantity& height = section.reinforcement;
    ++(height.measured() ? told : hidden);
    EXPECT_TRUE(!height.measured() || std::abs(height.value - 0.0015) < 4.0 * height.sigma) << height.value;
  }
  const double radius = (0.004 * 0.004 + 0.0015 * 0.0015) / 0.003, turn = 2.0 * std::asin(0.004 / radius);
  const double area = 0.5 * radius * radius * (turn - std::sin(turn));
  EXPECT_NEAR(result.volume_length, 0.012, 1e-8) << "the pore belongs to the weld, its volume is bridged";
  EXPECT_NEAR(result.volume.value, area * result.volume_length, 3.0 * result.volume.sigma);
  EXPECT_LT(result.volume.sigma, 0.01 * result.volume.value);
  EXPECT_GT(told, 45);
  EXPECT_GE(hidden, 6) << "the pore is eight rows long";
}

TEST(MissingPieces, CountsNoVolumeWhereLongStretchesOfRowsAreMissing)
{
  Scan scan = IdealScanner()(IdealWeld());
  const WeldResult whole = WeldMeasurer().measure(scan);
  EXPECT_NEAR(whole.length.value, 60 * 2e-4, 1e-8) << "60 rows, each stands for half a pitch on either side";
  EXPECT_NEAR(whole.length.sigma, 2e-4, 1e-8);
  EXPECT_NEAR(whole.length.value, whole.volume_length, 1e-9) << "of a weld that was measured throughout";
  const auto drop = [&scan](std::size_t from, std::size_t to)
  {
    for (std::size_t row = from; row < to; ++row)
      scan.rows[row].points.clear();
  };
  drop(10, 14);
  const WeldResult bridged = WeldMeasurer().measure(scan);
  EXPECT_NEAR(bridged.volume_length, whole.volume_length, 1e-9);
  EXPECT_NEAR(bridged.volume.value, whole.volume.value, 3.0 * bridged.volume.sigma);
  drop(25, 40);
  const WeldResult broken = WeldMeasurer().measure(scan);
  EXPECT_NEAR(broken.volume_length, whole.volume_length - 0.003, 1e-9);
  EXPECT_NEAR(broken.volume.value / broken.volume_length, whole.volume.value / whole.volume_length,
              0.005 * whole.volume.value / whole.volume_length);
  EXPECT_NE(broken.reason.find("the volumes are of 9 mm of weld, 12 mm were seen"), std::string::npos) << broken.reason;
  EXPECT_NEAR(broken.length.value, whole.length.value, 1e-9) << "what is missing in between belongs to the weld";
}

TEST(MissingPieces, NamesSpatterAndMeasuresBesideIt)
{
  const IdealWeld weld;
  const auto surface = [&weld](double x, double y)
  {
    double z = weld(x, y);
    for (const Eigen::Vector2d& ball : { Eigen::Vector2d(0.001, 0.006), Eigen::Vector2d(0.010, 0.004) })
    {
      const double rest = 2.5e-7 - (Eigen::Vector2d(x, y) - ball).squaredNorm();
      z += rest > 0.0 ? std::sqrt(rest) : 0.0;
    }
    return z;
  };
  const WeldResult result = WeldMeasurer().measure(IdealScanner()(surface));
  ASSERT_EQ(result.spots.size(), 2u);
  for (const WeldSpot& spot : result.spots)
  {
    EXPECT_EQ(spot.kind, WeldSpot::Kind::Spatter);
    EXPECT_NEAR(spot.diameter.value, 0.001, 2e-4);
    EXPECT_NEAR(spot.height.value, 5e-4, 5e-5);
  }
  EXPECT_NEAR(result.spots[0].x, 0.010, 2e-4);
  for (const WeldSection& section : result.sections)
  {
    ASSERT_TRUE(section.hasBead());
    if (section.reinforcement.measured())
    {
      EXPECT_NEAR(section.reinforcement.value, 0.0015, 1.5e-5) << "spatter is no reinforcement, row " << section.row;
    }
  }
}

TEST(MissingPieces, TellsNoUndercutWhoseBottomMayLieInAHole)
{
  IdealWeld weld;
  weld.undercut = 0.0004;
  Scan scan = IdealScanner()(weld);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> chance;
  for (Profile& row : scan.rows)
  {
    std::vector<CloudPoint> left;
    std::copy_if(row.points.begin(), row.points.end(), std::back_inserter(left),
                 [&](const CloudPoint& /*point*/) { return chance(random) > 0.65; });
    row.points = left;
  }
  const WeldResult result = WeldMeasurer().measure(scan);
  ASSERT_TRUE(result.hasWeld()) << result.reason;
  EXPECT_GT(result.measured_share, 0.9);
  int told = 0;
  for (const WeldSection& section : result.sections)
  {
    const Quantity& depth = section.undercut_right;
    told += depth.measured() ? 1 : 0;
    EXPECT_TRUE(!depth.measured() || std::abs(depth.value - 0.0004) < 5.0 * depth.sigma)
        << depth.value << " +- " << depth.sigma;
  }
  EXPECT_LT(told, 30) << "most bottoms are not seen";
}

TEST(MissingPieces, TellsNoPoreWhereABeadEndsAbruptly)
{
  const IdealWeld weld;
  const auto surface = [&weld](double x, double y) { return weld(x, y) * std::clamp((0.0085 - y) / 0.0005, 0.0, 1.0); };
  const WeldResult result = WeldMeasurer().measure(IdealScanner()(surface));
  ASSERT_TRUE(result.hasWeld()) << result.reason;
  EXPECT_GT(result.length.value, 0.0075);
  EXPECT_TRUE(result.spots.empty()) << result.spots.front().s << ", of " << result.length.value;
}
