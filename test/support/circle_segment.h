#pragma once

#include <cmath>

namespace weld_profiler
{
/// Area of a circle's segment over a chord.
inline double segmentArea(double width, double height)
{
  if (height == 0.0)
    return 0.0;
  const double half = 0.5 * width, radius = 0.5 * (half * half + height * height) / height;
  const double angle = std::asin(half / radius);
  return radius * radius * (angle - std::sin(angle) * std::cos(angle));
}
}  // namespace weld_profiler
