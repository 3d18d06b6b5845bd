#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "simulation/stripe_band.h"

namespace weld_profiler
{
namespace simulation
{
/// Mean light into digital numbers: shot and read noise, clipping, encoding. Immutable, thread safe.
class Sensor
{
public:
  Sensor(const SceneParams& scene, int width, int height);

  std::size_t step() const { return static_cast<std::size_t>(width_) * channels_ * bytes_; }

  /// @param band        the laser's light.
  /// @param swapped     the band's rows are the image's columns.
  /// @param background  other light, width x height [DN], or empty.
  /// @param pixels      resized to step() * height.
  void develop(const StripeBand& band, bool swapped, const std::vector<float>& background, int frame,
               std::vector<std::uint8_t>& pixels) const;

private:
  struct Row
  {
    const float* laser = nullptr;       ///< mean signal, or null
    const float* background = nullptr;  ///< mean signal, or null
  };

  void dark(std::size_t offset, std::uint8_t* to) const;
  void lit(const Row& row, int v, std::size_t offset, std::uint8_t* to) const;
  void channel(int v, int index, std::vector<float>& laser_gain, std::vector<float>& other_gain) const;
  void encode(const float* values, std::size_t count, std::uint8_t* to) const;

  SceneSensor sensor_;
  bool filter_;
  std::uint64_t seed_;
  int width_, height_, channels_ = 1, bytes_ = 1;
  double variance_per_dn_ = 0.0;    ///< of shot noise [DN]
  std::vector<float> normal_;       ///< standard normal noise, read from random places
  std::vector<std::uint8_t> dark_;  ///< encoded noise of an unlit pixel, likewise
};
}  // namespace simulation
}  // namespace weld_profiler
