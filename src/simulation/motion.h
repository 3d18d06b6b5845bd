#pragma once

#include <vector>

#include "weld_profiler/simulation/scene_params.h"
#include "weld_profiler/simulation/simulated_scan.h"

namespace weld_profiler
{
namespace simulation
{
/// The stage: speed (1 + variation sin(2 pi t / period)), integrated in closed form. t = 0 is the first frame's stamp.
class Motion
{
public:
  explicit Motion(const SceneParams& scene);

  int frameCount() const { return frame_count_; }
  Stamp stamp(int frame) const;
  double seconds(Stamp stamp) const { return toSeconds(stamp - start_); }
  double duration() const { return static_cast<double>(frame_count_ - 1) / scene_.frame_rate; }
  double position(double seconds) const;

  /// Lowest stage position over a frame of the scan.
  double lowest() const;

  /// Stamps at a rate from a little before the first frame to a little after the last, on no frame's stamp.
  std::vector<Stamp> samples(double rate) const;
  std::vector<SimulatedEncoderSample> encoder() const;

private:
  SceneParams scene_;
  Stamp start_;
  int frame_count_;
};
}  // namespace simulation
}  // namespace weld_profiler
