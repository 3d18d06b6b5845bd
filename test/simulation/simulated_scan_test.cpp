#include "weld_profiler/simulation/simulated_scan.h"

#include <cmath>

#include <gtest/gtest.h>

#include "simulation/scenes.h"
#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
namespace
{
TEST(SimulatedScan, SeesAFlatPlateWhereTheClosedFormPutsIt)
{
  SceneParams scene = flatScene();
  scene.plates.height = 0.003;
  const SimulatedScan scan(scene);
  const std::vector<TruthCentre> truth = scan.truth(2);
  ASSERT_EQ(truth.size(), 1440U);
  const double depth = 0.25 - std::sqrt(0.75) * 0.003;  // the default rig: z = (0, 1/2, -sqrt(3/4)) in the camera
  for (const TruthCentre& centre : truth)
  {
    ASSERT_TRUE(centre.visible);
    ASSERT_NEAR(centre.v, 540.0 + 6000.0 * 0.5 * 0.003 / depth, 1e-6);
    ASSERT_NEAR(centre.x, (centre.u - 719.5) / 6000.0 * depth, 1e-10);
    ASSERT_NEAR(centre.y, 2 * 0.005 / 20.0, 1e-12);
    ASSERT_NEAR(centre.z, 0.003, 1e-12);
    ASSERT_NEAR(centre.normal_angle, M_PI / 2, 1e-6);
  }
}

TEST(SimulatedScan, ShowsTheGaugeStepAtItsHeightAndTheMarkInItsCorner)
{
  const SceneParams scene = chiralScene();
  const SimulatedScan scan(scene);
  int on_gauge = 0, on_mark = 0;
  for (int frame = 0; frame < scan.frameCount(); ++frame)
    for (const TruthCentre& centre : scan.truth(frame))
    {
      const bool gauge = std::abs(centre.x - 0.019) < 0.0059 && centre.y > 0.0221 && centre.y < 0.0339;
      const bool mark = std::abs(centre.x + 0.024) < 0.0029 && centre.y > 0.0031 && centre.y < 0.0079;
      on_gauge += gauge ? 1 : 0;
      on_mark += mark ? 1 : 0;
      if (gauge || mark)
      {
        ASSERT_NEAR(centre.z, gauge ? 0.001 : 0.0015, 1e-12);
      }
    }
  EXPECT_GT(on_gauge, 1000);
  EXPECT_GT(on_mark, 300);
}

TEST(SimulatedScan, IsNotItsMirrorImage)
{
  SceneParams scene = chiralScene();
  for (const bool part_moves : { false, true })
  {
    scene.part_moves = part_moves;
    const SimulatedScan scan(scene);
    // the weld leans from +y toward -x, the gauge lies at +x: with either sign of the axis
    EXPECT_NEAR(scan.surfaceHeight(0.019, 0.030), 0.001, 1e-9);
    EXPECT_NEAR(scan.surfaceHeight(-0.019, 0.030), 0.0, 1e-9);
    const double lean = std::tan(7.0 * M_PI / 180.0) * 0.010;
    EXPECT_GT(scan.surfaceHeight(-lean, 0.035), 0.0018);
    EXPECT_GT(scan.surfaceHeight(-lean - 0.0042, 0.035), scan.surfaceHeight(-lean + 0.0058, 0.035));
  }
}

TEST(SimulatedScan, TurnsThePictureRoundWhenThePartMovesInstead)
{
  SceneParams scene = chiralScene();
  scene.calibration.camera.distortion = {};
  const SimulatedScan sensor(scene);
  scene.part_moves = true;
  const SimulatedScan part(scene);
  const std::vector<TruthCentre> a = sensor.truth(25);
  const std::vector<TruthCentre> b = part.truth(25);
  ASSERT_GT(a.size(), 1400U);
  for (const TruthCentre& left : a)
    for (const TruthCentre& right : b)
      if (left.cell + right.cell == 1439)
      {
        ASSERT_NEAR(left.z, right.z, 1e-9) << "cell " << left.cell;
      }
}

TEST(SimulatedScan, RefusesAFrameItDoesNotHave)
{
  const SimulatedScan scan(flatScene());
  std::vector<std::uint8_t> pixels;
  EXPECT_THROW(scan.render(-1, pixels), PreconditionError);
  EXPECT_THROW(scan.truth(4), PreconditionError);
}

TEST(SimulatedScan, RefusesAnInvalidScene)
{
  SceneParams scene = flatScene();
  scene.frame_rate = -1.0;
  EXPECT_THROW(SimulatedScan scan(scene), ConfigError);
}

TEST(SimulatedScan, HidesWhatAStepHidesFromTheCamera)
{
  // The camera looks back from +y at 30 deg: a 2 mm step hides the 2 tan(30) = 1.155 mm before it, to about 12 um
  // (rays are followed in steps of 25 um).
  SceneParams scene = flatScene();
  scene.gauge = SceneBlock{ 0.002, 0.0, 0.004, 0.01, 0.01 };
  scene.frame_count = 80;
  scene.speed = 0.001;  // 50 um a frame
  const SimulatedScan scan(scene);
  int hidden = 0;
  for (int frame = 0; frame < scan.frameCount(); ++frame)
  {
    const auto truth = scan.truth(frame);
    ASSERT_EQ(truth.size(), 1440U);
    const TruthCentre& middle = truth[720];
    const double edge = 0.004 - 0.002 * std::tan(M_PI / 6);
    if (std::abs(middle.y - edge) < 15e-6)
      continue;
    const bool hides = middle.y > edge;
    EXPECT_EQ(middle.visible, !hides) << "y " << middle.y;
    hidden += hides ? 1 : 0;
    const auto pixels = frameOf(scan, frame);
    EXPECT_EQ(columnMoments(scan, pixels, 720, middle.v).sum > 100.0, !hides) << "y " << middle.y;
    EXPECT_TRUE(truth[100].visible) << "beside the block";
  }
  EXPECT_EQ(hidden, 22);
}

TEST(SimulatedScan, CastsTheLasersShadowBesideABlock)
{
  SceneParams scene = flatScene();
  scene.frame_count = 1;
  scene.part_start = 0.005;
  scene.gauge = SceneBlock{ 0.004, 0.015, 0.0, 0.01, 0.02 };
  scene.laser.standoff = 0.1;
  const SimulatedScan scan(scene);
  // seen from the emitter 100 mm above x = 0, the edge at 20 mm and 4 mm hides up to 20 * 100 / 96 = 20.833 mm
  int shadow = 0, lit = 0;
  for (const TruthCentre& centre : scan.truth(0))
    if (centre.x > 0.02002 && centre.x < 0.02082)
    {
      ++shadow;
      EXPECT_FALSE(centre.visible) << centre.x;
    }
    else if (centre.x > 0.02086 && centre.x < 0.029)
    {
      ++lit;
      EXPECT_TRUE(centre.visible) << centre.x;
    }
  EXPECT_GT(shadow, 10);
  EXPECT_GT(lit, 150);
}
}  // namespace
}  // namespace weld_profiler
