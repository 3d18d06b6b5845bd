#pragma once

#include <cmath>
#include <cstdint>

namespace weld_profiler
{
namespace simulation
{
/// Mixes a 64-bit value (SplitMix64's finaliser, Steele et al. 2014).
inline std::uint64_t mix(std::uint64_t value)
{
  value += 0x9E3779B97F4A7C15ULL;
  value = (value ^ (value >> 30)) * 0xBF58476D1CE4E5B9ULL;
  value = (value ^ (value >> 27)) * 0x94D049BB133111EBULL;
  return value ^ (value >> 31);
}

/// One seed out of several numbers, so that each frame, row and purpose has its own stream.
inline std::uint64_t mix(std::uint64_t seed, std::uint64_t a, std::uint64_t b = 0)
{
  return mix(mix(mix(seed) ^ a) ^ b);
}

/// SplitMix64. Own generator and own distributions: those of the standard library differ from one to the next.
class Random
{
public:
  explicit Random(std::uint64_t seed) : state_(mix(seed)) {}

  std::uint64_t next()
  {
    const std::uint64_t value = mix(state_);
    state_ += 0x9E3779B97F4A7C15ULL;
    return value;
  }

  /// In [0, 1).
  double uniform() { return static_cast<double>(next() >> 11) * (1.0 / 9007199254740992.0); }

  double uniform(double low, double high) { return low + (high - low) * uniform(); }

  /// Standard normal (Box-Muller).
  double normal()
  {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
    return radius * std::cos(6.283185307179586 * uniform());
  }

private:
  std::uint64_t state_;
};
}  // namespace simulation
}  // namespace weld_profiler
