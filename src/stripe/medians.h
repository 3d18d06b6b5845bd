#pragma once

#include <algorithm>
#include <array>

namespace weld_profiler
{
inline float median3(float a, float b, float c)
{
  return std::max(std::min(a, b), std::min(std::max(a, b), c));
}

inline float median5(const std::array<float, 5>& values)
{
  const float low = std::max(std::min(values[0], values[1]), std::min(values[3], values[4]));
  const float high = std::min(std::max(values[0], values[1]), std::max(values[3], values[4]));
  return median3(low, values[2], high);
}
}  // namespace weld_profiler
