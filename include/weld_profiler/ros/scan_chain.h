#pragma once

#include <memory>
#include <optional>
#include <string>

#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/JointState.h>
#include <tf2/buffer_core.h>

#include "weld_profiler/StripeProfile.h"
#include "weld_profiler/geometry/scan_frame.h"
#include "weld_profiler/geometry/triangulator.h"
#include "weld_profiler/ros/tf_pose_source.h"
#include "weld_profiler/scan/encoder_pose_source.h"
#include "weld_profiler/scan/scan_builder.h"

namespace weld_profiler
{
/// Everything triangulation can be told, beside the calibration file.
struct ScanChainParams
{
  std::string scan_frame = "weld_profiler_scan";  ///< name of the scan frame
  std::string motion = "stage";                   ///< stage: joint_states; tf: the sensor's pose from tf
  std::string fixed_frame;                        ///< frame of the clouds with motion tf, required there
  bool use_camera_info = false;                   ///< camera_info, not the calibration file, gives the camera
  EncoderParams encoder;
  ScanParams scan;

  void validate() const;  ///< @throws ConfigError naming field, value and range

  template <class Visitor>
  void visit(Visitor&& v)
  {
    v("scan_frame", scan_frame);
    v("motion", motion);
    v("fixed_frame", fixed_frame);
    v("use_camera_info", use_camera_info);
    encoder.visit(v);
    scan.visit(v);
  }
};

/// Messages in, placed profiles and scans out: checks, triangulation, placing, assembly. The live nodelet and the
/// offline command feed this same class. Not thread safe; the caller serialises.
class ScanChain
{
public:
  /// @param transforms  asked with motion tf; outlives this object.
  /// @throws ConfigError naming field, value and range.
  ScanChain(const ScanChainParams& params, const Calibration& calibration, const tf2::BufferCore& transforms,
            ScanBuilder::Sinks sinks);

  void addCameraInfo(const sensor_msgs::CameraInfo& info);

  /// A stripe that does not fit the calibration is dropped and counted (camera_info, image_size, bad_message).
  void addStripe(const StripeProfile& stripe);

  /// @return whether the calibration's joint is in the message.
  bool addJoints(const sensor_msgs::JointState& joints);

  /// Places what waits; for motion tf, call when transforms may have come.
  void poll() { builder_->poll(); }

  ScanBuilder& builder() { return *builder_; }
  const ScanBuilder& builder() const { return *builder_; }
  const EncoderTrack* encoder() const { return encoder_ != nullptr ? &encoder_->track() : nullptr; }
  const ScanFrame& scanFrame() const { return scan_frame_; }
  const Calibration& calibration() const { return calibration_; }
  const std::string& cloudFrame() const { return cloud_frame_; }

  /// The last reason for refusing input, one line; empty when there was none since the last call.
  std::string takeProblem();

private:
  bool fits(const StripeProfile& stripe);
  void refuse(const std::string& reason, const std::string& text);

  ScanChainParams params_;
  Calibration calibration_;
  ScanFrame scan_frame_;
  std::string cloud_frame_;
  std::shared_ptr<const Triangulator> triangulator_;
  EncoderPoseSource* encoder_ = nullptr;  // owned by builder_
  TfPoseSource* transforms_ = nullptr;    // owned by builder_
  std::unique_ptr<ScanBuilder> builder_;
  std::optional<sensor_msgs::CameraInfo> info_;
  std::string info_problem_;
  Stripe stripe_;
  std::string problem_;
};
}  // namespace weld_profiler
