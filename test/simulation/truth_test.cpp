#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "simulation/oracle.h"
#include "simulation/scenes.h"

namespace weld_profiler
{
namespace
{
struct Variant
{
  std::string name;
  std::function<void(SceneParams&)> change;
};

class Truth : public ::testing::TestWithParam<Variant>
{
protected:
  SceneParams scene() const
  {
    SceneParams scene = chiralScene();
    GetParam().change(scene);
    return scene;
  }
};

TEST_P(Truth, LiesOnTheLaserPlaneOnTheSurfaceAndUnderItsPixel)
{
  const SimulatedScan scan(scene());
  int visible = 0;
  for (int frame = 0; frame < scan.frameCount(); frame += 3)
  {
    const double stage = scan.stagePosition(scan.stamp(frame));
    for (const TruthCentre& centre : scan.truth(frame))
    {
      const Vector3d point(centre.x, centre.y, centre.z);
      const Vector3d camera = toCamera(scan.calibration(), point, stage);
      ASSERT_NEAR(vector(scan.calibration().laser_plane.normal).dot(camera), scan.calibration().laser_plane.distance,
                  1e-9);
      const Vector2d pixel = project(scan.calibration().camera, camera);
      ASSERT_NEAR(pixel.x(), centre.u, 1e-5) << "frame " << frame << " cell " << centre.cell;
      ASSERT_NEAR(pixel.y(), centre.v, 1e-5) << "frame " << frame << " cell " << centre.cell;
      ASSERT_NEAR(scan.surfaceHeight(centre.x, centre.y), centre.z, 1e-9);
      ASSERT_NEAR(scan.direction() == Direction::AlongU ? centre.u : centre.v, centre.cell, 1e-6);
      visible += centre.visible ? 1 : 0;
    }
  }
  const int cells = scan.direction() == Direction::AlongU ? scan.width() : scan.height();
  EXPECT_GT(visible, 0.95 * cells * 14) << "else the loop has seen little";
}

TEST_P(Truth, RisesStrictlyInCellsAndNamesTheNormal)
{
  const SimulatedScan scan(scene());
  const std::vector<TruthCentre> truth = scan.truth(20);
  ASSERT_GT(truth.size(), 900U);
  int compared = 0;
  for (std::size_t i = 1; i + 1 < truth.size(); ++i)
  {
    ASSERT_GT(truth[i].cell, truth[i - 1].cell);
    ASSERT_GT(truth[i].normal_angle, -M_PI / 2);
    ASSERT_LE(truth[i].normal_angle, M_PI / 2);
    const Vector2d along(truth[i + 1].u - truth[i - 1].u, truth[i + 1].v - truth[i - 1].v);
    if (along.norm() > 3.0)  // a wall between
      continue;
    const Vector2d normal(std::cos(truth[i].normal_angle), std::sin(truth[i].normal_angle));
    ++compared;
    ASSERT_NEAR(normal.dot(along.normalized()), 0.0, 0.25) << "cell " << truth[i].cell;  // toes bend by 20 deg at once
  }
  EXPECT_GT(compared, 900);
}

INSTANTIATE_TEST_SUITE_P(
    Rigs, Truth,
    ::testing::Values(Variant{ "SensorMoves", [](SceneParams&) {} },
                      Variant{ "PartMoves", [](SceneParams& scene) { scene.part_moves = true; } },
                      Variant{ "FallingPosition", [](SceneParams& scene) { scene.speed = -0.02; } },
                      Variant{ "StartsElsewhere", [](SceneParams& scene) { scene.start_position = 0.31; } },
                      Variant{ "StripeAlongV", [](SceneParams& scene) { scene.rig_roll_deg = 90.0; } },
                      Variant{ "StripeAlongVTheOtherWay", [](SceneParams& scene) { scene.rig_roll_deg = -90.0; } },
                      Variant{ "RolledALittle", [](SceneParams& scene) { scene.rig_roll_deg = 5.0; } },
                      Variant{ "SlantedAxis",
                               [](SceneParams& scene) {
                                 scene.calibration.stage.axis = { { 0.1, -0.8, -0.5916079783 } };
                               } },
                      Variant{ "Curved", [](SceneParams& scene) { scene.weld.curvature = 3.0; } }),
    [](const auto& info) { return info.param.name; });
}  // namespace
}  // namespace weld_profiler
