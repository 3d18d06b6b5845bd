#include "width_growth.h"

#include <algorithm>
#include <cmath>

#include "control_variates.h"

namespace weld_profiler
{
namespace
{
constexpr float kNone = 1e9F;
}

void WidthGrowth::learn(const ColumnTrack& track, const float* held, const float* slope)
{
  constexpr int kStretch = ControlVariates::kStretch;
  constexpr int kInside = 8;
  constexpr float kHalf = 4.5F;  // of nine columns
  constexpr float kFar = kStretch - 2 * kInside;
  const auto slots = static_cast<int>(track.slots());
  const int count = (slots + kStretch - 1) / kStretch;
  const auto width = [&](int slot)
  {
    const bool seen = slot < slots && held[slot] > kHalf;
    const float tangent = seen ? slope[slot] : 0.0F;
    return seen ? track.sigma[static_cast<std::size_t>(slot)] / std::sqrt(1.0F + tangent * tangent) : 0.0F;
  };
  rise_.assign(static_cast<std::size_t>(count), kNone);
  for (int i = 0; i < count; ++i)
  {
    const float from = width(i * kStretch + kInside);
    const float to = width((i + 1) * kStretch - kInside);
    if (from > 0.0F && to > 0.0F)
      rise_[static_cast<std::size_t>(i)] = 2.0F * (to - from) / (to + from) / kFar;
  }
  // At an end of a piece, where one of the neighbours is missing, the next one on the other side is asked.
  const auto agreed = [](float a, float b, float c)
  {
    if (!(a < kNone && b < kNone && c < kNone) || !(a * b > 0.0F) || !(a * c > 0.0F))
      return 0.0F;
    return std::copysign(std::min({ std::abs(a), std::abs(b), std::abs(c) }), a);
  };
  const auto rise = [&](int i) { return i >= 0 && i < count ? rise_[static_cast<std::size_t>(i)] : kNone; };
  growth_.assign(static_cast<std::size_t>(count), 0.0F);
  for (int i = 0; i < count; ++i)
  {
    const int before = rise(i - 1) < kNone ? i - 1 : i + 2;
    const int after = rise(i + 1) < kNone ? i + 1 : i - 2;
    growth_[static_cast<std::size_t>(i)] = agreed(rise(i), rise(before), rise(after));
  }
}
}  // namespace weld_profiler
