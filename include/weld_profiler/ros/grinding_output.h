#pragma once

#include <memory>
#include <string>

#include <ros/node_handle.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>
#include <Eigen/Geometry>

#include "weld_profiler/WeldMeasurement.h"
#include "weld_profiler/core/scan.h"
#include "weld_profiler/weld/weld_evaluation.h"

namespace weld_profiler
{
/// What grinding takes of a measured weld, on its topics (README.md), latched: `weld_points`, lines, passes
/// and meshes, all in one frame.
class GrindingOutput
{
public:
  /// @param frame  everything is given in; empty = the cloud's.
  GrindingOutput(const ros::NodeHandle& node, const std::string& frame);

  /// Listens to tf, if a frame was asked for. Transforms from before are not known.
  void listen();

  /// @param summary  of this evaluation: header of the cloud, id, calibration, settings.
  /// @throws InputError when there is no transform at the scan's stamp: nothing is given out then.
  void publish(const Scan& scan, const WeldEvaluation& evaluation, const WeldMeasurement& summary) const;

private:
  Eigen::Isometry3d outputFrom(const std_msgs::Header& header) const;

  std::string frame_;
  tf2_ros::Buffer transforms_;
  std::unique_ptr<tf2_ros::TransformListener> listener_;
  ros::Publisher points_, toe_left_, toe_right_, crest_, passes_, pass_poses_;
  ros::Publisher bead_, target_, bead_shape_, target_shape_;
};
}  // namespace weld_profiler
