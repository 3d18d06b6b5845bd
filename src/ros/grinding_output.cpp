#include "weld_profiler/ros/grinding_output.h"

#include "weld_profiler/core/errors.h"
#include "weld_profiler/ros/grinding_messages.h"
#include "weld_profiler/ros/weld_messages.h"

namespace weld_profiler
{
namespace
{
constexpr double kTransformTime = 1.0;  // [s]
}

GrindingOutput::GrindingOutput(const ros::NodeHandle& node, const std::string& frame) : frame_(frame)
{
  ros::NodeHandle handle = node;
  points_ = handle.advertise<sensor_msgs::PointCloud2>("weld_points", 1, true);
  toe_left_ = handle.advertise<geometry_msgs::PoseArray>("toe_left", 1, true);
  toe_right_ = handle.advertise<geometry_msgs::PoseArray>("toe_right", 1, true);
  crest_ = handle.advertise<geometry_msgs::PoseArray>("crest", 1, true);
  passes_ = handle.advertise<GrindingPasses>("grinding_passes", 1, true);
  pass_poses_ = handle.advertise<geometry_msgs::PoseArray>("grinding_poses", 1, true);
  bead_ = handle.advertise<pcl_msgs::PolygonMesh>("bead_mesh", 1, true);
  target_ = handle.advertise<pcl_msgs::PolygonMesh>("target_mesh", 1, true);
  bead_shape_ = handle.advertise<shape_msgs::Mesh>("bead_shape", 1, true);
  target_shape_ = handle.advertise<shape_msgs::Mesh>("target_shape", 1, true);
}

void GrindingOutput::listen()
{
  if (!frame_.empty())
    listener_ = std::make_unique<tf2_ros::TransformListener>(transforms_);
}

Eigen::Isometry3d GrindingOutput::outputFrom(const std_msgs::Header& header) const
{
  if (frame_.empty() || frame_ == header.frame_id)
    return Eigen::Isometry3d::Identity();
  try
  {
    const geometry_msgs::Transform moved =
        transforms_.lookupTransform(frame_, header.frame_id, header.stamp, ros::Duration(kTransformTime)).transform;
    const Eigen::Quaterniond rotation(moved.rotation.w, moved.rotation.x, moved.rotation.y, moved.rotation.z);
    return Eigen::Translation3d(moved.translation.x, moved.translation.y, moved.translation.z) * rotation.normalized();
  }
  catch (const tf2::TransformException& error)
  {
    throw InputError("no transform from " + header.frame_id + " to output_frame " + frame_ + " at the scan's stamp (" +
                     error.what() + "): passes, meshes and weld_points are not given out");
  }
}

void GrindingOutput::publish(const Scan& scan, const WeldEvaluation& evaluation, const WeldMeasurement& summary) const
{
  std_msgs::Header header = summary.header;
  const Eigen::Isometry3d output = outputFrom(header);
  const sensor_msgs::PointCloud2Ptr cloud = weldCloud(scan, evaluation.result);
  if (!frame_.empty())
    header.frame_id = frame_;
  transformCloud(*cloud, output, header.frame_id);
  points_.publish(sensor_msgs::PointCloud2ConstPtr(cloud));
  const GrindingPlan plan = transformed(evaluation.plan, output, header.frame_id);
  GrindingPasses passes = passesMessage(plan, header);
  passes.weld_id = summary.weld_id;
  passes.calibration_hash = summary.calibration_hash;
  passes.settings = summary.settings;
  passes_.publish(passes);
  pass_poses_.publish(passPoses(plan, header));
  toe_left_.publish(poseArray(plan.toe_left, header));
  toe_right_.publish(poseArray(plan.toe_right, header));
  crest_.publish(poseArray(plan.crest, header));
  bead_.publish(polygonMessage(plan.bead, header));
  target_.publish(polygonMessage(plan.target, header));
  bead_shape_.publish(shapeMessage(plan.bead));
  target_shape_.publish(shapeMessage(plan.target));
}
}  // namespace weld_profiler
