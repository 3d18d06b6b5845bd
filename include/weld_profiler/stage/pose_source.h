#pragma once

#include <string>

#include "weld_profiler/core/profile.h"
#include "weld_profiler/core/stamp.h"

namespace weld_profiler
{
/// Answer to "where was the sensor at this stamp?"
struct PoseAnswer
{
  enum class Kind
  {
    Placed,  ///< pose is valid
    Wait,    ///< not bracketed yet, ask again after the next sample
    Never    ///< cannot be placed any more; reason says why
  };
  Kind kind = Kind::Wait;
  SensorPose pose;
  std::string reason;  ///< with Never: encoder_gap, before_first_sample, time_backwards, encoder_not_finite, ...
                       ///< with Wait: what is missing, the reason should the input end now (no_encoder, ...)
};

/// Where the sensor was: from encoder samples, or from tf. Not thread safe; the caller serialises.
class PoseSource
{
public:
  virtual ~PoseSource() = default;
  virtual PoseAnswer at(Stamp stamp) = 0;
  virtual void beginScan() {}  ///< a new scan begins: what was added up (path length) starts at 0, samples stay
  virtual void reset() = 0;    ///< forgets all samples
};
}  // namespace weld_profiler
