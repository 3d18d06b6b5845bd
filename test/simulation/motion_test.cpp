#include <cmath>

#include <gtest/gtest.h>

#include "simulation/oracle.h"
#include "simulation/scenes.h"

namespace weld_profiler
{
namespace
{
TEST(Motion, MovesAtTheSpeedItWasTold)
{
  SceneParams scene = chiralScene();
  scene.frame_count = 400;
  scene.start_position = -0.1;
  const SimulatedScan scan(scene);
  EXPECT_DOUBLE_EQ(scan.stagePosition(scan.stamp(0)), -0.1);
  double slowest = 1e9, fastest = 0.0, previous = 0.0;
  for (int i = 0; i <= 1000; ++i)
  {
    const double position = scan.stagePosition(scan.stamp(0) + i * 10000000LL);
    const double speed = (position - previous) / 0.01;
    if (i > 0)
    {
      slowest = std::min(slowest, speed);
      fastest = std::max(fastest, speed);
    }
    previous = position;
  }
  EXPECT_NEAR(slowest, 0.010, 1e-5);
  EXPECT_NEAR(fastest, 0.030, 1e-5);
  EXPECT_NEAR(scan.stagePosition(scan.stamp(0) + 10000000000LL), -0.1 + 0.02 * 10.0, 1e-9)
      << "ten seconds, whole periods";
}

TEST(Motion, SamplesTheEncoderAroundEveryFrame)
{
  SceneParams scene = chiralScene();
  scene.calibration.stage.metres_per_unit = 0.001;
  const SimulatedScan scan(scene);
  const auto samples = scan.encoder();
  ASSERT_GT(samples.size(), 1000U);
  EXPECT_LT(samples.front().stamp, scan.stamp(0));
  EXPECT_GT(samples.back().stamp, scan.stamp(scan.frameCount() - 1));
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    EXPECT_NEAR(samples[i].position * 0.001, scan.stagePosition(samples[i].stamp), 1e-12);
    if (i > 0)
    {
      EXPECT_EQ(samples[i].stamp - samples[i - 1].stamp, 2000000) << "500 Hz";
    }
  }
}

TEST(Motion, RoundsTheEncoderToItsResolution)
{
  SceneParams scene = flatScene();
  scene.encoder_resolution = 1e-5;
  const SimulatedScan scan(scene);
  const auto samples = scan.encoder();
  ASSERT_FALSE(samples.empty());
  for (const auto& sample : samples)
  {
    EXPECT_NEAR(std::remainder(sample.position, 1e-5), 0.0, 1e-12);
    EXPECT_NEAR(sample.position, scan.stagePosition(sample.stamp), 0.5001e-5);
  }
}

TEST(Motion, GivesPosesThatPlaceTheTruthWhenItMovesThroughTf)
{
  SceneParams scene = chiralScene();
  scene.motion = "tf";
  const SimulatedScan scan(scene);
  const auto poses = scan.poses();
  ASSERT_GT(poses.size(), 400U);
  int checked = 0;
  for (int frame = 0; frame < scan.frameCount(); frame += 7)
  {
    const Stamp stamp = scan.stamp(frame);
    std::size_t after = 0;
    while (poses[after].stamp < stamp)
      ++after;
    ASSERT_GT(after, 0U);
    const SimulatedPose& a = poses[after - 1];
    const SimulatedPose& b = poses[after];
    const double share = static_cast<double>(stamp - a.stamp) / static_cast<double>(b.stamp - a.stamp);
    const auto turn = [](const SimulatedPose& pose) {
      return Eigen::Quaterniond(Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(pose.rotation.data()));
    };
    const Eigen::Quaterniond rotation = turn(a).slerp(share, turn(b));
    const Vector3d translation = (1 - share) * vector(a.translation) + share * vector(b.translation);
    for (const TruthCentre& centre : scan.truth(frame))
    {
      const Vector3d camera = rotation.inverse() * (Vector3d(centre.x, centre.y, centre.z) - translation);
      ASSERT_NEAR(vector(scan.calibration().laser_plane.normal).dot(camera), scan.calibration().laser_plane.distance,
                  2e-7);
      const Vector2d pixel = project(scan.calibration().camera, camera);
      ASSERT_NEAR(pixel.x(), centre.u, 0.005);  // the speed changes between two poses: 0.1 um
      ASSERT_NEAR(pixel.y(), centre.v, 0.005);
      ++checked;
    }
  }
  EXPECT_GT(checked, 8000);
  const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> first(poses.front().rotation.data());
  const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> last(poses.back().rotation.data());
  EXPECT_GT(Eigen::AngleAxisd(first.transpose() * last).angle(), 5.9 * M_PI / 180.0);
}

TEST(Motion, HasNoPosesWhenTheStageMoves)
{
  EXPECT_TRUE(SimulatedScan(flatScene()).poses().empty());
}

TEST(Motion, HasThePapersTwoHundredFramesByDefault)
{
  const SimulatedScan scan(scenePreset("realistic"));
  EXPECT_EQ(scan.frameCount(), 200);
  EXPECT_EQ(scan.width(), 1440);
  EXPECT_EQ(scan.height(), 1080);
  EXPECT_EQ(scan.encoding(), "mono8");
  EXPECT_EQ(scan.stamp(0), fromSeconds(1000.0));
  EXPECT_EQ(scan.stamp(1) - scan.stamp(0), 50000000);
}
}  // namespace
}  // namespace weld_profiler
