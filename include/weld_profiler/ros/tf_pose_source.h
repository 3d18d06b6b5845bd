#pragma once

#include <string>

#include <tf2/buffer_core.h>

#include "weld_profiler/stage/pose_source.h"

namespace weld_profiler
{
/// The sensor's pose at a stamp from tf, for a robot that carries the sensor and turns it. Waits for the transform,
/// never takes the latest. SensorPose::stage is the path length that the camera's origin travelled between placed
/// profiles [m].
class TfPoseSource : public PoseSource
{
public:
  /// @param buffer       outlives this object.
  /// @param fixed_frame  the cloud's frame.
  TfPoseSource(const tf2::BufferCore& buffer, std::string fixed_frame);

  /// The frame of the coming profiles (header.frame_id of the stripe).
  void setCameraFrame(const std::string& camera_frame) { camera_frame_ = camera_frame; }

  PoseAnswer at(Stamp stamp) override;
  void beginScan() override;
  void reset() override { beginScan(); }  // the buffer is the listener's, which clears it itself

private:
  const tf2::BufferCore& buffer_;
  std::string fixed_frame_;
  std::string camera_frame_;
  bool travelled_ = false;
  double path_ = 0.0;
  Eigen::Vector3d last_position_ = Eigen::Vector3d::Zero();
};
}  // namespace weld_profiler
