#pragma once

#include <cstdint>
#include <deque>

#include "weld_profiler/core/stamp.h"
#include "weld_profiler/stage/pose_source.h"
#include "weld_profiler/stage/unplaced.h"

namespace weld_profiler
{
/// Settings of EncoderTrack.
struct EncoderParams
{
  double max_encoder_gap = 0.05;  ///< two samples further apart do not bracket a profile [s], [1e-6, 10]
  int max_samples = 20000;        ///< samples remembered, 2..10000000

  void validate() const;  ///< @throws ConfigError naming field, value and range

  template <class Visitor>
  void visit(Visitor&& v)
  {
    v("max_encoder_gap", max_encoder_gap);
    v("max_samples", max_samples);
  }
};

/// Encoder samples and the stage position between them: linear, never extrapolated. Not thread safe.
/// Time running backwards by kClockJump or more (a looping bag) forgets all earlier samples; a sample that lies back by
/// less came late and is left out. A NaN sample is kept as a hole: what it would
/// bracket is not placed (`encoder_not_finite`). Two samples of one stamp: the later replaces the earlier. A stamp at
/// which there is a sample is placed there, however far its neighbours are.
class EncoderTrack
{
public:
  struct Answer
  {
    PoseAnswer::Kind kind = PoseAnswer::Kind::Wait;
    double position = 0.0;  ///< [m], with Placed
    const char* reason = unplaced::kNoEncoder;
  };

  /// @throws ConfigError as EncoderParams::validate.
  explicit EncoderTrack(const EncoderParams& params);

  /// @param position  [m].
  /// @return false when time ran backwards and the earlier samples were forgotten.
  bool add(Stamp stamp, double position);

  Answer at(Stamp stamp) const;
  void reset() { samples_.clear(); }

  bool empty() const { return samples_.empty(); }
  std::size_t size() const { return samples_.size(); }
  Stamp latestStamp() const { return samples_.empty() ? 0 : samples_.back().stamp; }           ///< 0 when empty
  double latestPosition() const { return samples_.empty() ? 0.0 : samples_.back().position; }  ///< [m], 0 when empty
  double speed() const;  ///< over the last samples (about 50 ms) [m/s]; 0 with fewer than two finite ones

private:
  struct Sample
  {
    Stamp stamp;
    double position;
  };
  EncoderParams params_;
  std::deque<Sample> samples_;
};
}  // namespace weld_profiler
