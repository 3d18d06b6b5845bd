#include "weld_profiler/scan/encoder_pose_source.h"

#include <gtest/gtest.h>

#include "weld_profiler/core/errors.h"

using namespace weld_profiler;

namespace
{
constexpr Stamp kMs = 1000000;
}

TEST(EncoderPoseSource, PlacesInTheScanFrameAtTheInterpolatedPosition)
{
  Calibration rig;
  rig.stage.metres_per_unit = 1e-3;  // a joint that counts millimetres
  EncoderPoseSource poses(rig, EncoderParams{});
  poses.addSample(100 * kMs, 10.0);
  poses.addSample(110 * kMs, 20.0);
  const PoseAnswer answer = poses.at(104 * kMs);
  ASSERT_EQ(answer.kind, PoseAnswer::Kind::Placed);
  EXPECT_NEAR(answer.pose.stage, 0.014, 1e-15);
  EXPECT_TRUE(answer.pose.cloud_T_camera.isApprox(ScanFrame(rig).scanTCamera(0.014), 1e-14));
  // the scan's origin is seen on the optical axis at stage 0; now the sensor has gone on by 14 mm along y
  const Eigen::Vector3d on_axis = answer.pose.cloud_T_camera * Eigen::Vector3d(0.0, 0.0, 0.25);
  EXPECT_LT((on_axis - Eigen::Vector3d(0.0, 0.014, 0.0)).norm(), 1e-14);
}

TEST(EncoderPoseSource, PassesOnWhyItCannotPlace)
{
  EncoderPoseSource poses(Calibration{}, EncoderParams{});
  EXPECT_EQ(poses.at(0).kind, PoseAnswer::Kind::Wait);
  EXPECT_EQ(poses.at(0).reason, unplaced::kNoEncoder);
  EXPECT_TRUE(poses.addSample(1000 * kMs, 0.0));
  EXPECT_EQ(poses.at(0).kind, PoseAnswer::Kind::Never);
  EXPECT_EQ(poses.at(0).reason, unplaced::kBeforeFirstSample);
  EXPECT_FALSE(poses.addSample(50 * kMs, 0.0));
  poses.reset();
  EXPECT_TRUE(poses.track().empty());
}

TEST(EncoderPoseSource, RefusesBadConfiguration)
{
  Calibration rig;
  rig.stage.metres_per_unit = 0.0;
  EXPECT_THROW(EncoderPoseSource(rig, EncoderParams{}), ConfigError);
  EncoderParams params;
  params.max_encoder_gap = -1.0;
  EXPECT_THROW(EncoderPoseSource(Calibration{}, params), ConfigError);
}
