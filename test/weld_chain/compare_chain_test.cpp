#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "tools/simulated_cloud.h"
#include "weld/ground_weld.h"
#include "weld_profiler/simulation/random_welds.h"
#include "weld_profiler/weld/scan_comparison.h"

namespace weld_profiler
{
namespace
{
constexpr double kBefore = -0.0015;  // where the scan after begins, so that it covers the one before [m]

/// A simulated weld before and after grinding, scanned through the whole chain, and the truth of both surfaces.
struct GroundWeld
{
  /// @param rest  reinforcement that is left standing [m].
  GroundWeld(std::uint64_t seed, double rest) : before_scene(randomWeldScene(seed)), after_scene(before_scene)
  {
    after_scene.seed = seed + 10000;  // other noise and speckle; no spatter, no ripples any more
    after_scene.spatter.count = 0;
    after_scene.weld.ripple_height = 0.0;
    after_scene.weld.reinforcement = rest;
    after_scene.part_start = kBefore;
    after_scene.scan_length = before_scene.scan_length - 2.0 * kBefore;
    const SimulatedScan simulated_before(before_scene), simulated_after(after_scene);
    before = simulatedCloud(simulated_before);
    // a cloud's y counts from where its scan began
    after = moved(simulatedCloud(simulated_after), motionAbout({ 0, 0, 0 }, { 0, kBefore, 0 }, { 0, 0, 0 }));
    integrate(simulated_before, simulated_after);
  }

  double length() const { return to_y - from_y; }

  /// How deep below the target a gouge reaches that is taken off the surface after.
  double deepest(const Dip& gouge) const
  {
    constexpr double kStep = 5e-5;
    const SimulatedScan simulated_before(before_scene), simulated_after(after_scene);
    double depth = 0.0;
    for (double y = gouge.y - 0.002; y < gouge.y + 0.002; y += kStep)
      for (double x = gouge.x - 0.002; x < gouge.x + 0.002; x += kStep)
        depth = std::max(
            depth, simulated_before.targetHeight(x, y) - simulated_after.surfaceHeight(x, y - kBefore) + gouge(x, y));
    return depth;
  }

  SceneParams before_scene, after_scene;
  Scan before, after;
  double removed = 0.0, remaining = 0.0;  ///< true volumes over the scan before [m^3]
  double from_y = 0.0, to_y = 0.0;        ///< of its first row and its last [m]

private:
  static double rowY(const Profile& row)
  {
    double sum = 0.0;
    for (const CloudPoint& point : row.points)
      sum += static_cast<double>(point.y);
    return sum / static_cast<double>(row.points.size());
  }

  void integrate(const SimulatedScan& simulated_before, const SimulatedScan& simulated_after)
  {
    constexpr double kStep = 5e-5, kHalfField = 0.029;
    from_y = rowY(before.rows.front()), to_y = rowY(before.rows.back());
    for (double y = from_y + 0.5 * kStep; y < to_y; y += kStep)
    {
      for (double x = -kHalfField; x < kHalfField; x += kStep)
      {
        const double z = simulated_after.surfaceHeight(x, y - kBefore);
        removed += (simulated_before.surfaceHeight(x, y) - z) * kStep * kStep;
        const TrueLabel label = simulated_before.surfaceLabel(x, y);
        if (label == TrueLabel::Bead || label == TrueLabel::Spatter)
          remaining += std::max(0.0, z - simulated_before.targetHeight(x, y)) * kStep * kStep;
      }
    }
  }
};

void expectVolume(const char* what, const Quantity& volume, double truth, const GroundWeld& weld)
{
  ASSERT_TRUE(volume.measured()) << what;
  EXPECT_LT(std::abs(volume.value - truth), 3.0 * volume.sigma)
      << what << ": " << 1e9 * volume.value << ", truth " << 1e9 * truth << ", sigma " << 1e9 * volume.sigma << " mm^3";
  EXPECT_NEAR(volume.value, truth, std::max(0.01 * truth, 5e-6 * weld.before_scene.weld.width * weld.length())) << what;
}

const Eigen::Isometry3d kRefixed = motionAbout({ 0.0, 0.01, 0.0 }, { 3e-4, -4e-4, 1.2e-3 }, { 1.0, -0.8, 0.3 });
}  // namespace

TEST(CompareChain, ABeadOnPlateGroundFlush)
{
  const GroundWeld weld(2, 0.0);
  const ScanComparison comparison = ScanComparer().compare(weld.before, moved(weld.after, kRefixed));
  EXPECT_EQ(comparison.kind, WeldKind::BeadOnPlate);
  expectVolume("removed", comparison.removed_volume, weld.removed, weld);
  expectVolume("remaining", comparison.remaining_volume, 0.0, weld);
  EXPECT_TRUE(comparison.over_ground.empty()) << "undercuts were there before";
  EXPECT_GT(comparison.measured_share, 0.99);
}

TEST(CompareChain, AButtWeldWithSomethingLeft)
{
  const GroundWeld weld(3, 2e-4);
  const ScanComparison comparison = ScanComparer().compare(weld.before, moved(weld.after, kRefixed));
  EXPECT_EQ(comparison.kind, WeldKind::Butt);
  expectVolume("removed", comparison.removed_volume, weld.removed, weld);
  expectVolume("remaining", comparison.remaining_volume, weld.remaining, weld);
  EXPECT_TRUE(comparison.aligned.across_told);
  const Scan reversed = turnedRound(moved(weld.after, kRefixed));
  EXPECT_NEAR(ScanComparer().compare(weld.before, reversed).removed_volume.value, comparison.removed_volume.value,
              1e-4 * comparison.removed_volume.value);
}

TEST(CompareChain, AFilletAndItsGouges)
{
  GroundWeld weld(7, 5e-4);
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
  EXPECT_NEAR(spot.depth.value, weld.deepest(gouge), 2e-5) << "a mean over 0.25 mm of a rounded face";
  EXPECT_NEAR(spot.x, gouge.x, 0.0015);
  EXPECT_NEAR(spot.y, gouge.y, 0.0015);
  const double taken = M_PI * gouge.depth * (std::pow(gouge.radius, 2.0) + gouge.radius * 4e-4 + 4e-4 * 4e-4 / 3.0);
  const double plate = M_PI * dip.depth * (std::pow(dip.radius, 2.0) + dip.radius * 4e-4 + 4e-4 * 4e-4 / 3.0);
  // the dip in the plate lies beyond the weld's surroundings
  EXPECT_NEAR(comparison.removed_volume.value, weld.removed + taken, 0.01 * weld.removed + plate);
}
}  // namespace weld_profiler
