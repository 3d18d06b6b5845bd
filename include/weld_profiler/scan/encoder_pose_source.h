#pragma once

#include "weld_profiler/geometry/calibration.h"
#include "weld_profiler/geometry/scan_frame.h"
#include "weld_profiler/stage/encoder_track.h"
#include "weld_profiler/stage/pose_source.h"

namespace weld_profiler
{
/// The sensor's pose in the scan frame, from the stage's encoder. Not thread safe.
class EncoderPoseSource : public PoseSource
{
public:
  /// @throws ConfigError as validateCalibration and EncoderParams::validate.
  EncoderPoseSource(const Calibration& calibration, const EncoderParams& params);

  /// @param joint_position  as in JointState; times metres_per_unit it is metres.
  /// @return false when time ran backwards and the earlier samples were forgotten: tell ScanBuilder::timeBackwards.
  bool addSample(Stamp stamp, double joint_position);

  PoseAnswer at(Stamp stamp) override;
  void reset() override { track_.reset(); }

  const EncoderTrack& track() const { return track_; }
  const ScanFrame& frame() const { return frame_; }

private:
  ScanFrame frame_;
  double metres_per_unit_;
  EncoderTrack track_;
};
}  // namespace weld_profiler
