#include <cmath>

#include <gtest/gtest.h>

#include "weld_profiler/ros/messages.h"
#include "weld_profiler/ros/tf_pose_source.h"

namespace weld_profiler
{
namespace
{
class TfPose : public ::testing::Test
{
protected:
  void add(double seconds, double x, double turn)
  {
    const Eigen::Matrix3d rotation = Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    buffer_.setTransform(
        transformMessage(fromSeconds(seconds), rotation, Eigen::Vector3d(x, 0.0, 0.0), FrameNames{ "base", "camera" }),
        "test");
  }

  tf2::BufferCore buffer_{ ros::Duration(1000.0) };
  TfPoseSource source_{ buffer_, "base" };
};

TEST_F(TfPose, WaitsForAFrameThatIsNotKnownYet)
{
  source_.setCameraFrame("camera");
  EXPECT_EQ(source_.at(fromSeconds(1.0)).kind, PoseAnswer::Kind::Wait);
}

TEST_F(TfPose, InterpolatesAndNeverTakesTheLatest)
{
  source_.setCameraFrame("camera");
  add(1.0, 0.0, 0.0);
  EXPECT_EQ(source_.at(fromSeconds(1.5)).kind, PoseAnswer::Kind::Wait);
  add(2.0, 0.2, 0.4);
  const PoseAnswer answer = source_.at(fromSeconds(1.5));
  ASSERT_EQ(answer.kind, PoseAnswer::Kind::Placed);
  EXPECT_NEAR(answer.pose.cloud_T_camera.translation().x(), 0.1, 1e-12);
  EXPECT_NEAR(Eigen::AngleAxisd(answer.pose.cloud_T_camera.rotation()).angle(), 0.2, 1e-12);
}

TEST_F(TfPose, GivesUpWhatLiesBeforeTheFirstTransform)
{
  source_.setCameraFrame("camera");
  add(2.0, 0.0, 0.0);
  add(3.0, 0.0, 0.0);
  const PoseAnswer answer = source_.at(fromSeconds(1.0));
  EXPECT_EQ(answer.kind, PoseAnswer::Kind::Never);
  EXPECT_EQ(answer.reason, "before_first_transform");
}

TEST_F(TfPose, StageIsThePathTravelled)
{
  source_.setCameraFrame("camera");
  add(1.0, 0.0, 0.0);
  add(2.0, 0.3, 0.0);
  add(3.0, 0.1, 0.0);
  EXPECT_NEAR(source_.at(fromSeconds(1.0)).pose.stage, 0.0, 1e-12);
  EXPECT_NEAR(source_.at(fromSeconds(2.0)).pose.stage, 0.3, 1e-9);
  EXPECT_NEAR(source_.at(fromSeconds(3.0)).pose.stage, 0.5, 1e-9) << "there and back adds up";
}
}  // namespace
}  // namespace weld_profiler
