#include "weld_profiler/scan/encoder_pose_source.h"

namespace weld_profiler
{
EncoderPoseSource::EncoderPoseSource(const Calibration& calibration, const EncoderParams& params)
  : frame_(calibration), metres_per_unit_(calibration.stage.metres_per_unit), track_(params)
{
}

bool EncoderPoseSource::addSample(Stamp stamp, double joint_position)
{
  return track_.add(stamp, joint_position * metres_per_unit_);
}

PoseAnswer EncoderPoseSource::at(Stamp stamp)
{
  const EncoderTrack::Answer found = track_.at(stamp);
  PoseAnswer answer;
  answer.kind = found.kind;
  answer.reason = found.reason;
  if (found.kind == PoseAnswer::Kind::Placed)
  {
    answer.pose.stage = found.position;
    answer.pose.cloud_T_camera = frame_.scanTCamera(found.position);
  }
  return answer;
}
}  // namespace weld_profiler
