#include <cmath>

#include <gtest/gtest.h>

#include "simulation/scenes.h"

namespace weld_profiler
{
namespace
{
std::size_t at(const SimulatedScan& scan, int u, int v)
{
  return static_cast<std::size_t>(v) * static_cast<std::size_t>(scan.width()) + static_cast<std::size_t>(u);
}

TEST(StripeImage, IsAGaussianOfTheAskedWidthAndPeakOnTheFlatPlate)
{
  const SimulatedScan scan(flatScene());
  const auto pixels = frameOf(scan, 1);
  for (int u = 0; u < scan.width(); u += 7)
    for (int v = 532; v <= 548; ++v)
      ASSERT_NEAR(pixels[at(scan, u, v)], 180.0 * std::exp(-0.5 * (v - 540) * (v - 540) / 4.0), 0.2) << u << ", " << v;
}

TEST(StripeImage, HasItsCentroidOnTheTrueCentre)
{
  SceneParams scene = flatScene();
  scene.weld = SceneParams().weld;
  scene.weld.yaw_deg = 5.0;
  scene.frame_count = 100;
  const SimulatedScan scan(scene);
  const auto pixels = frameOf(scan, 60);
  double squares = 0.0;
  int count = 0;
  for (const TruthCentre& centre : scan.truth(60))
  {
    const double error = columnMoments(scan, pixels, centre.cell, centre.v).mean - centre.v;
    squares += error * error;
    ++count;
  }
  ASSERT_EQ(count, 1440);
  // the lens rounds the toes (a kink of 22 deg in the image under sigma 1.2 px): 0.19 px there, nothing elsewhere
  EXPECT_LT(std::sqrt(squares / count), 0.03);
}

TEST(StripeImage, GetsThinnerAcrossItselfOnAFlank)
{
  SceneParams scene = flatScene();
  scene.plates.angle_deg = 30.0;
  const SimulatedScan scan(scene);
  const auto pixels = frameOf(scan, 0);
  const auto truth = scan.truth(0);
  ASSERT_EQ(truth.size(), 1440U);
  int checked = 0;
  for (std::size_t i = 100; i < truth.size(); i += 100)
  {
    if (std::abs(truth[i].u - 719.5) < 30)
      continue;
    // the column shows the sheet's own thickness, which the flank leaves alone, and the lens, which cuts it at a slant
    const double slant = 1.0 / std::sin(std::abs(truth[i].normal_angle));
    const double expected = std::sqrt(4.0 - 1.44 + 1.44 * slant * slant);
    EXPECT_NEAR(columnMoments(scan, pixels, static_cast<int>(i), truth[i].v).sigma, expected, 0.06);
    EXPECT_LT(expected / slant, 1.99);
    ++checked;
  }
  EXPECT_EQ(checked, 13);
}

TEST(StripeImage, GetsDimmerOnAFlankByLambertsCosine)
{
  SceneParams scene = flatScene();
  scene.plates.angle_deg = 30.0;
  scene.laser.shading = 1.0;
  scene.laser.standoff = 5.0;
  scene.laser.lens_sigma_px = 0.5;
  const SimulatedScan scan(scene);
  const auto truth = scan.truth(0);
  ASSERT_EQ(truth.size(), 1440U);
  const Moments moments = columnMoments(scan, frameOf(scan, 0), 300, truth[300].v);
  EXPECT_NEAR(moments.sum / (180.0 * 2.0 * std::sqrt(2 * M_PI)), std::cos(15.0 * M_PI / 180.0), 0.02);
}

TEST(StripeImage, BlursAnEdgeThatPassesDuringTheExposure)
{
  SceneParams scene = flatScene();
  scene.gauge = SceneBlock{ 0.001, 0.0, -0.005, 0.01, 0.00624 };  // ends at y = 1.24 mm
  scene.speed = 0.02;
  scene.frame_count = 3;
  scene.exposure = 0.04;  // 0.8 mm
  const double high = 540.0 + 6000.0 * 0.5 * 0.001 / (0.25 - std::sqrt(0.75) * 0.001);
  for (const bool blur : { false, true })
  {
    scene.motion_blur = blur;
    const SimulatedScan scan(scene);
    const auto pixels = frameOf(scan, 1);  // y = 1 mm, 0.6 to 1.4
    const double on = pixels[at(scan, 720, static_cast<int>(std::lround(high)))] / 180.0;
    const double off = pixels[at(scan, 720, 540)] / 180.0;
    EXPECT_NEAR(on, blur ? 0.8 : 1.0, 0.05);
    EXPECT_NEAR(off, blur ? 0.2 : 0.0, 0.05);
    EXPECT_EQ(scan.truth(1)[720].visible, !blur) << "two stripes in one cell";
  }
}

TEST(StripeImage, ShowsAGhostAtItsOffset)
{
  SceneParams scene = flatScene();
  scene.laser.ghost = 0.1;
  scene.laser.ghost_offset_px = 20.0;
  const SimulatedScan scan(scene);
  EXPECT_NEAR(frameOf(scan, 0)[at(scan, 700, 560)], 18.0, 0.2);
}

TEST(StripeImage, ShowsAHaloOfItsShare)
{
  SceneParams scene = flatScene();
  scene.laser.glow = 0.05;
  const SimulatedScan scan(scene);
  EXPECT_NEAR(frameOf(scan, 0)[at(scan, 700, 570)], 180.0 * 0.05 * std::exp(-0.5), 0.5) << "one sigma of 30 px away";
}

TEST(StripeImage, MirrorsASteepFlankOntoThePlate)
{
  SceneParams scene = flatScene();
  scene.weld = SceneParams().weld;
  scene.weld.width = 0.008;
  scene.weld.reinforcement = 0.003;  // 74 deg at the toe
  scene.weld.start = -0.02;
  scene.weld.yaw_deg = 8.0;
  const SimulatedScan dark(scene);
  scene.laser.interreflection = 0.5;
  const SimulatedScan bright(scene);
  const auto without = frameOf(dark, 1);
  const auto with = frameOf(bright, 1);
  double added = 0.0;
  for (std::size_t i = 0; i < with.size(); ++i)
  {
    ASSERT_GE(with[i], without[i] - 1e-9);
    added += with[i] - without[i];
  }
  EXPECT_GT(added, 1000.0);
}

TEST(StripeImage, GlintsWhereTheSurfaceMirrorsTheLaserIntoTheCamera)
{
  SceneParams scene = flatScene();
  scene.laser.specular = 3.0;
  scene.weld = SceneParams().weld;
  scene.weld.ripple_height = 0.0002;
  scene.weld.start = -0.02;
  const SimulatedScan scan(scene);
  double brightest = 0.0;
  for (int frame = 0; frame < 4; ++frame)
    for (const double value : frameOf(scan, frame))
      brightest = std::max(brightest, value);
  EXPECT_GT(brightest, 230.0);
}

TEST(StripeImage, ShowsARegionOfTheSensorExactlyAsTheWholeDoes)
{
  SceneParams scene = chiralScene();
  scene.sensor.noise = false;
  const SimulatedScan whole(scene);
  scene.calibration.camera.roi_x = 101;
  scene.calibration.camera.roi_y = 431;
  scene.calibration.camera.roi_width = 801;
  scene.calibration.camera.roi_height = 222;
  const SimulatedScan part(scene);
  ASSERT_EQ(part.width(), 801);
  ASSERT_EQ(part.height(), 222);
  const auto all = frameOf(whole, 15);
  const auto some = frameOf(part, 15);
  ASSERT_EQ(some.size(), 801U * 222U);
  int differing = 0;
  for (int v = 0; v < 222; ++v)
    for (int u = 0; u < 801; ++u)  // the cut's points lie elsewhere between the columns: a grey level
      differing += std::abs(some[at(part, u, v)] - all[at(whole, u + 101, v + 431)]) > 1.0 ? 1 : 0;
  EXPECT_LT(differing, 60) << "a few at walls";
  const auto truth = part.truth(15);
  const auto reference = whole.truth(15);
  ASSERT_GT(truth.size(), 790U);
  for (const TruthCentre& centre : truth)
    for (const TruthCentre& same : reference)
      if (same.cell == centre.cell + 101)
      {
        ASSERT_NEAR(centre.v + 431.0, same.v, 1e-6);
      }
}

TEST(StripeImage, RunsAlongTheColumnsWhenTheRigIsRolled)
{
  SceneParams scene = flatScene();
  scene.calibration.camera.cx = 720.0;
  scene.rig_roll_deg = 90.0;
  const SimulatedScan scan(scene);
  ASSERT_EQ(scan.direction(), Direction::AlongV);
  const auto truth = scan.truth(0);
  ASSERT_EQ(truth.size(), 1080U);
  const auto pixels = frameOf(scan, 0);
  for (const TruthCentre& centre : truth)
  {
    ASSERT_NEAR(centre.u, 720.0, 1e-6);
    ASSERT_NEAR(centre.normal_angle, 0.0, 1e-6);
    ASSERT_NEAR(pixels[at(scan, 720, centre.cell)], 180.0, 0.2);
  }
}
}  // namespace
}  // namespace weld_profiler
