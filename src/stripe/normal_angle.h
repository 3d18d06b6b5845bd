#pragma once

#include <algorithm>
#include <cmath>

namespace weld_profiler
{
/// The angle of a line's normal, which points either way, in (-pi/2, pi/2] [rad].
/// @param angle  in [-pi, pi].
inline float normalAngle(double angle)
{
  constexpr double kHalfPi = 1.57079632679489661923;
  if (angle > kHalfPi)
    angle -= 2.0 * kHalfPi;
  else if (angle <= -kHalfPi)
    angle += 2.0 * kHalfPi;
  constexpr float kLargest = 1.57079625F;  // the float nearest pi/2 lies above it
  return std::clamp(static_cast<float>(angle), -kLargest, kLargest);
}
}  // namespace weld_profiler
