#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <rosbag/bag.h>

#include "tools/staged_output.h"
#include "weld_profiler/core/frame.h"
#include "weld_profiler/geometry/calibration.h"

namespace weld_profiler
{
/// One encoder sample, in the joint's units.
struct EncoderSample
{
  Stamp stamp = 0;
  double position = 0.0;
};

/// The sensor's pose in a fixed frame, for /tf.
struct PoseSample
{
  Stamp stamp = 0;
  double qx = 0.0, qy = 0.0, qz = 0.0, qw = 1.0;  ///< unit quaternion
  double x = 0.0, y = 0.0, z = 0.0;               ///< [m]
};

/// Names in a scan's bag.
struct ScanBagNames
{
  std::string name_space = "/profiler";
  std::string camera_frame = "camera_optical_frame";
  std::string fixed_frame = "world";
  std::string joint = "stage_joint";
};

/// Writes image_raw, camera_info, joint_states and /tf of one scan in the order of their stamps; a message's time in
/// the bag is its stamp, so that a replay keeps the order. No ROS master, same input -> same bytes.
class ScanBagWriter
{
public:
  /// @param output  takes the bag in as `target`; commit it after close(). @throws InputError naming target and cause.
  ScanBagWriter(StagedOutput& output, const std::string& target, ScanBagNames names, const CameraCalibration& camera);

  ~ScanBagWriter();
  ScanBagWriter(const ScanBagWriter&) = delete;
  ScanBagWriter& operator=(const ScanBagWriter&) = delete;

  /// What the stage says over the whole scan; call before the first frame. Stamps must rise.
  void setEncoder(std::vector<EncoderSample> samples) { encoder_ = std::move(samples); }
  void setPoses(std::vector<PoseSample> samples) { poses_ = std::move(samples); }

  /// Writes all samples up to the frame's stamp, then the frame. Stamps must rise.
  void writeFrame(Frame&& frame);

  /// Writes the remaining samples and ends the file. @throws InputError, also for a full disk.
  void close();

private:
  void writeSamplesUntil(Stamp stamp);
  void writeEncoder(const EncoderSample& sample);
  void writePose(const PoseSample& sample);

  template <class Message>
  void write(const std::string& topic, const Message& message, const Stamp& stamp);
  [[noreturn]] void giveUp(const std::string& cause);

  std::string target_;
  ScanBagNames names_;
  CameraCalibration camera_;
  std::unique_ptr<rosbag::Bag> bag_;
  std::vector<EncoderSample> encoder_;
  std::vector<PoseSample> poses_;
  std::size_t next_encoder_ = 0;
  std::size_t next_pose_ = 0;
};
}  // namespace weld_profiler
