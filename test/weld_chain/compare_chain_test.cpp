#include <cmath>

#include <gtest/gtest.h>

#include "weld/ground_case.h"
#include "weld/ground_weld.h"
#include "weld_profiler/weld/scan_comparison.h"

namespace weld_profiler
{
namespace
{
using weld_accuracy::GroundCase;

/// How deep below the target a gouge reaches that is taken off the surface after.
double deepest(const GroundCase& weld, const Dip& gouge)
{
  constexpr double kStep = 5e-5, kAround = 0.002;
  double depth = 0.0;
  for (double y = gouge.y - kAround; y < gouge.y + kAround; y += kStep)
    for (double x = gouge.x - kAround; x < gouge.x + kAround; x += kStep)
      depth = std::max(depth, weld.target(x, y) - weld.surfaceAfter(x, y) + gouge(x, y));
  return depth;
}

void expectVolume(const char* what, const Quantity& volume, double truth, const GroundCase& weld)
{
  ASSERT_TRUE(volume.measured()) << what;
  EXPECT_LT(std::abs(volume.value - truth), 3.0 * volume.sigma)
      << what << ": " << 1e9 * volume.value << ", truth " << 1e9 * truth << ", sigma " << 1e9 * volume.sigma << " mm^3";
  EXPECT_NEAR(volume.value, truth, std::max(0.01 * truth, 5e-6 * weld.width() * weld.length())) << what;
}

const Eigen::Isometry3d kRefixed = motionAbout({ 0.0, 0.01, 0.0 }, { 3e-4, -4e-4, 1.2e-3 }, { 1.0, -0.8, 0.3 });
}  // namespace

TEST(CompareChain, ABeadOnPlateGroundFlush)
{
  const GroundCase weld(2, 0.0);
  const ScanComparison comparison = ScanComparer().compare(weld.before, moved(weld.after, kRefixed));
  EXPECT_EQ(comparison.kind, WeldKind::BeadOnPlate);
  expectVolume("removed", comparison.removed_volume, weld.removed, weld);
  expectVolume("remaining", comparison.remaining_volume, 0.0, weld);
  EXPECT_TRUE(comparison.over_ground.empty()) << "undercuts were there before";
  EXPECT_GT(comparison.measured_share, 0.99);
}

TEST(CompareChain, AButtWeldWithSomethingLeft)
{
  // of 0.2 mm the flatter toe of the two offset plates is no longer seen, but the undercuts are
  for (const double rest : { 2e-4, 4e-4 })
  {
    SCOPED_TRACE(rest);
    const GroundCase weld(3, rest);
    const ScanComparison comparison = ScanComparer().compare(weld.before, moved(weld.after, kRefixed));
    EXPECT_EQ(comparison.kind, WeldKind::Butt);
    expectVolume("removed", comparison.removed_volume, weld.removed, weld);
    expectVolume("remaining", comparison.remaining_volume, weld.remaining, weld);
    EXPECT_TRUE(comparison.aligned.across_told);
    EXPECT_TRUE(comparison.aligned.by_toes || comparison.aligned.by_undercuts);
    const Scan reversed = turnedRound(moved(weld.after, kRefixed));
    EXPECT_NEAR(ScanComparer().compare(weld.before, reversed).removed_volume.value, comparison.removed_volume.value,
                1e-4 * comparison.removed_volume.value);
  }
}

TEST(CompareChain, AnOffsetButtWeldGroundFlush)
{
  const GroundCase weld(27, 0.0);  // plates 1 mm apart in height
  const ScanComparison comparison = ScanComparer().compare(weld.before, moved(weld.after, kRefixed));
  EXPECT_TRUE(comparison.aligned.by_undercuts);
  expectVolume("removed", comparison.removed_volume, weld.removed, weld);
  expectVolume("remaining", comparison.remaining_volume, 0.0, weld);
  EXPECT_LT(comparison.removed_volume.sigma, 5e-6 * weld.width() * weld.length()) << "10 mm^3 without the undercuts";
  EXPECT_TRUE(comparison.over_ground.empty());
}

TEST(CompareChain, AFilletAndItsGouges)
{
  GroundCase weld(7, 5e-4);
  const double flush = 5e-4;  // what is left above the chord
  const Dip gouge{ 0.0005, 0.006, 0.001, 1.2e-4 + flush }, dip{ -0.013, 0.012, 0.001, 4e-5 };
  for (Profile& row : weld.after.rows)
  {
    for (CloudPoint& point : row.points)
    {
      const auto x = static_cast<double>(point.x), y = static_cast<double>(point.y);
      point.z -= static_cast<float>(gouge(x, y) + dip(x, y));
    }
  }
  const ScanComparison comparison = ScanComparer().compare(weld.before, moved(weld.after, kRefixed));
  EXPECT_EQ(comparison.kind, WeldKind::Fillet);
  EXPECT_TRUE(comparison.aligned.across_told);
  ASSERT_EQ(comparison.over_ground.size(), 1u) << "0.04 mm in a plate is not over the limit";
  const OverGroundSpot& spot = comparison.over_ground.front();
  EXPECT_NEAR(spot.depth.value, deepest(weld, gouge), 2e-5) << "a mean over 0.25 mm of a rounded face";
  EXPECT_NEAR(spot.x, gouge.x, 0.0015);
  EXPECT_NEAR(spot.y, gouge.y, 0.0015);
  const double taken = M_PI * gouge.depth * (std::pow(gouge.radius, 2.0) + gouge.radius * 4e-4 + 4e-4 * 4e-4 / 3.0);
  const double plate = M_PI * dip.depth * (std::pow(dip.radius, 2.0) + dip.radius * 4e-4 + 4e-4 * 4e-4 / 3.0);
  // the dip in the plate lies beyond the weld's surroundings
  EXPECT_NEAR(comparison.removed_volume.value, weld.removed + taken, 0.01 * weld.removed + plate);
}
}  // namespace weld_profiler
