#include "weld_profiler/ros/tf_pose_source.h"

#include <geometry_msgs/TransformStamped.h>
#include <tf2/exceptions.h>

#include "weld_profiler/ros/messages.h"

namespace weld_profiler
{
namespace
{
Eigen::Isometry3d isometry(const geometry_msgs::Transform& transform)
{
  const auto& q = transform.rotation;
  const auto& t = transform.translation;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized().toRotationMatrix();
  pose.translation() = Eigen::Vector3d(t.x, t.y, t.z);
  return pose;
}
}  // namespace

TfPoseSource::TfPoseSource(const tf2::BufferCore& buffer, std::string fixed_frame)
  : buffer_(buffer), fixed_frame_(std::move(fixed_frame))
{
}

PoseAnswer TfPoseSource::at(Stamp stamp)
{
  PoseAnswer answer;
  answer.reason = "no_transform";
  try
  {
    // where tf ends tells "not yet" from "never": lookupTransform's exception is one type for both
    const geometry_msgs::TransformStamped latest = buffer_.lookupTransform(fixed_frame_, camera_frame_, ros::Time(0));
    const bool is_static = latest.header.stamp.isZero();
    if (!is_static && latest.header.stamp < toRosTime(stamp))
      return answer;
    const geometry_msgs::TransformStamped transform =
        buffer_.lookupTransform(fixed_frame_, camera_frame_, toRosTime(stamp));
    answer.pose.cloud_T_camera = isometry(transform.transform);
    const Eigen::Vector3d position = answer.pose.cloud_T_camera.translation();
    if (travelled_)
      path_ += (position - last_position_).norm();
    travelled_ = true;
    last_position_ = position;
    answer.pose.stage = path_;
    answer.kind = PoseAnswer::Kind::Placed;
  }
  catch (const tf2::ExtrapolationException&)
  {
    answer.kind = PoseAnswer::Kind::Never;
    answer.reason = "before_first_transform";
  }
  catch (const tf2::TransformException&)
  {
    answer.kind = PoseAnswer::Kind::Wait;  // a frame that is not known yet
  }
  return answer;
}

void TfPoseSource::beginScan()
{
  travelled_ = false;
  path_ = 0.0;
}
}  // namespace weld_profiler
