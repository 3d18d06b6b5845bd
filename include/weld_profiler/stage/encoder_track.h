#pragma once

#include <cstdint>
#include <deque>

#include "weld_profiler/core/stamp.h"
#include "weld_profiler/stage/pose_source.h"

namespace weld_profiler
{
/// Settings of EncoderTrack.
struct EncoderParams
{
  double max_encoder_gap = 0.05;  ///< two samples further apart do not bracket a profile [s], (0, 10]
  int max_samples = 20000;        ///< samples remembered, 2..10000000

  void validate() const;          ///< @throws ConfigError naming field, value and range

  template <class Visitor>
  void visit(Visitor&& v)
  {
    v("max_encoder_gap", max_encoder_gap);
    v("max_samples", max_samples);
  }
};

/// Encoder samples and the stage position between them: linear, never extrapolated.
/// Time running backwards (a looping bag) forgets all earlier samples. A NaN sample is kept as a hole: what it would
/// bracket is not placed (`encoder_not_finite`). Two samples of one stamp: the later replaces the earlier.
class EncoderTrack
{
public:
  struct Answer
  {
    PoseAnswer::Kind kind = PoseAnswer::Kind::Wait;
    double position = 0.0;  ///< [m], with Placed
    const char* reason = "no_encoder";
  };

  explicit EncoderTrack(const EncoderParams& params);

  /// @param position  [m].
  /// @return false when time ran backwards and the earlier samples were forgotten.
  bool add(Stamp stamp, double position);

  Answer at(Stamp stamp) const;
  void reset();

  bool empty() const { return samples_.empty(); }
  Stamp latestStamp() const { return samples_.back().stamp; }
  double latestPosition() const { return samples_.back().position; }
  double speed() const;  ///< over the last samples (about 50 ms) [m/s]; 0 with fewer than two

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
