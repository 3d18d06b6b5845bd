#include "simulation/motion.h"

#include <algorithm>
#include <cmath>

namespace weld_profiler
{
namespace simulation
{
namespace
{
constexpr double kTwoPi = 6.283185307179586;
constexpr double kMargin = 0.1;  // encoder samples this long before the first and after the last frame [s]
constexpr double kPhase = 0.37;  // of a sample's period: samples must not fall on frames by chance

int framesOf(const SceneParams& scene)
{
  if (scene.frame_count > 0)
    return scene.frame_count;
  return std::max(1, static_cast<int>(std::lround(scene.scan_length / std::abs(scene.speed) * scene.frame_rate)));
}
}  // namespace

Motion::Motion(const SceneParams& scene)
  : scene_(scene), start_(fromSeconds(scene.start_time)), frame_count_(framesOf(scene))
{
}

Stamp Motion::stamp(int frame) const
{
  return start_ + fromSeconds(frame / scene_.frame_rate);
}

double Motion::position(double seconds) const
{
  const double omega = kTwoPi / scene_.speed_period;
  const double wave = scene_.speed_variation / omega * (1.0 - std::cos(omega * seconds));
  return scene_.start_position + scene_.speed * (seconds + wave);
}

double Motion::lowest() const
{
  return std::min(position(0.0), position(duration()));
}

std::vector<Stamp> Motion::samples(double rate) const
{
  const double first = -std::ceil(kMargin * rate) + kPhase;
  const int count = static_cast<int>(std::ceil((duration() + kMargin) * rate - first)) + 1;
  std::vector<Stamp> stamps;
  stamps.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
    stamps.push_back(start_ + fromSeconds((first + i) / rate));
  return stamps;
}

std::vector<SimulatedEncoderSample> Motion::encoder() const
{
  std::vector<SimulatedEncoderSample> result;
  for (const Stamp stamp : samples(scene_.encoder_rate))
  {
    double metres = position(seconds(stamp));
    if (scene_.encoder_resolution > 0.0)
      metres = std::round(metres / scene_.encoder_resolution) * scene_.encoder_resolution;
    result.push_back(SimulatedEncoderSample{ stamp, metres / scene_.calibration.stage.metres_per_unit });
  }
  return result;
}
}  // namespace simulation
}  // namespace weld_profiler
