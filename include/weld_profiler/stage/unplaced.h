#pragma once

namespace weld_profiler
{
/// Why a profile was not placed: keys of FrameBalance::unplaced, and PoseAnswer::reason.
namespace unplaced
{
constexpr const char* kNoEncoder = "no_encoder";                   ///< no sample ever came
constexpr const char* kBeforeFirstSample = "before_first_sample";  ///< older than all samples remembered
constexpr const char* kAfterLastSample = "after_last_sample";      ///< the input ended before a sample behind it came
constexpr const char* kEncoderGap = "encoder_gap";                 ///< the samples around it lie too far apart
constexpr const char* kEncoderNotFinite = "encoder_not_finite";    ///< a sample next to it was NaN or infinite
constexpr const char* kPoseNotFinite = "pose_not_finite";          ///< the pose source answered with NaN or infinity
constexpr const char* kTimeBackwards = "time_backwards";           ///< time jumped back while it waited (looping bag)
constexpr const char* kWaitingTooLong = "waiting_too_long";        ///< pushed out of the full queue
constexpr const char* kRestarted = "restarted";                    ///< a new scan was begun while it waited
}  // namespace unplaced
}  // namespace weld_profiler
