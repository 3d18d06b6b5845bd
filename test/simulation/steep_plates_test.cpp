#include <cmath>

#include <gtest/gtest.h>

#include "simulation/oracle.h"
#include "simulation/scenes.h"

namespace weld_profiler
{
namespace
{
constexpr double kRadPerDeg = M_PI / 180.0;

/// Two bare plates as a fillet's stand, the right one steeper.
SceneParams corner(double angle_deg, double tilt_deg)
{
  SceneParams scene = flatScene();
  scene.plates.angle_deg = angle_deg;
  scene.plates.tilt_deg = tilt_deg;
  scene.plates.x = 0.001;
  scene.plates.height = -0.012;
  return scene;
}

class SteepPlates : public ::testing::TestWithParam<std::pair<double, double>>
{
protected:
  SceneParams scene() const { return corner(GetParam().first, GetParam().second); }
};

TEST_P(SteepPlates, RiseFromTheSeamAtTheirAngles)
{
  const SimulatedScan scan(scene());
  const double left = (0.5 * GetParam().first - GetParam().second) * kRadPerDeg;
  const double right = (0.5 * GetParam().first + GetParam().second) * kRadPerDeg;
  for (const double d : { 0.0005, 0.004, 0.02 })
  {
    EXPECT_NEAR(scan.surfaceHeight(0.001 - d, 0.0002), -0.012 + d * std::tan(left), 1e-12);
    EXPECT_NEAR(scan.surfaceHeight(0.001 + d, 0.0002), -0.012 + d * std::tan(right), 1e-12);
  }
}

TEST_P(SteepPlates, HaveTheirTruthOnSheetAndSurfaceAndUnderTheirPixel)
{
  const SimulatedScan scan(scene());
  const double stage = scan.stagePosition(scan.stamp(1));
  int visible = 0;
  for (const TruthCentre& centre : scan.truth(1))
  {
    const Vector3d point(centre.x, centre.y, centre.z);
    const Vector3d camera = toCamera(scan.calibration(), point, stage);
    ASSERT_NEAR(vector(scan.calibration().laser_plane.normal).dot(camera), scan.calibration().laser_plane.distance,
                1e-9);
    const Vector2d pixel = project(scan.calibration().camera, camera);
    ASSERT_NEAR(pixel.x(), centre.u, 1e-5) << "cell " << centre.cell;
    ASSERT_NEAR(pixel.y(), centre.v, 1e-5) << "cell " << centre.cell;
    ASSERT_NEAR(scan.surfaceHeight(centre.x, centre.y), centre.z, 1e-9);
    visible += centre.visible ? 1 : 0;
  }
  EXPECT_GT(visible, 700) << "where the steeper plate is in the image";
}

TEST_P(SteepPlates, ShowTheirStripeOnTheTrueCentre)
{
  const SimulatedScan scan(scene());
  const auto pixels = frameOf(scan, 1);
  int checked = 0;
  for (const TruthCentre& centre : scan.truth(1))
  {
    // 30 columns from the seam the kink that the lens rounds is far; 20 rows from the edge the stripe is whole
    const bool whole = centre.v > 20.0 && centre.v < scan.height() - 21.0 && centre.cell > 20 &&
                       centre.cell < scan.width() - 21 && std::abs(centre.x - 0.001) > 30 * 42e-6;
    if (!centre.visible || !whole)
      continue;
    ASSERT_NEAR(columnMoments(scan, pixels, centre.cell, centre.v).mean, centre.v, 0.01) << "cell " << centre.cell;
    ++checked;
  }
  EXPECT_GT(checked, 600);
}

INSTANTIATE_TEST_SUITE_P(Pairs, SteepPlates,
                         ::testing::Values(std::make_pair(90.0, 0.0), std::make_pair(90.0, 10.0),
                                           std::make_pair(90.0, -15.0), std::make_pair(120.0, 0.0),
                                           std::make_pair(-60.0, 5.0), std::make_pair(0.0, 20.0)));
}  // namespace
}  // namespace weld_profiler
