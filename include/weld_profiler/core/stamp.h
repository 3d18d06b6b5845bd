#pragma once

#include <cstdint>

namespace weld_profiler
{
/// A point in time: nanoseconds since the epoch of whoever stamps (ROS time). An image's stamp is the middle of its
/// exposure.
using Stamp = std::int64_t;

constexpr double kNanosecondsPerSecond = 1e9;

/// A stamp that lies back by less than this came late on its way; by more, time jumped (a looping bag) [s].
constexpr double kClockJump = 0.5;

inline double toSeconds(Stamp duration)
{
  return static_cast<double>(duration) / kNanosecondsPerSecond;
}

inline Stamp fromSeconds(double seconds)
{
  return static_cast<Stamp>(seconds * kNanosecondsPerSecond + (seconds < 0.0 ? -0.5 : 0.5));
}
}  // namespace weld_profiler
