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
    const float rise = seen ? slope[slot] : 0.0F;
    return seen ? track.sigma[static_cast<std::size_t>(slot)] / std::sqrt(1.0F + rise * rise) : 0.0F;
  };
  rise_.assign(static_cast<std::size_t>(count) + 2, kNone);
  for (int i = 0; i < count; ++i)
  {
    const float from = width(i * kStretch + kInside);
    const float to = width((i + 1) * kStretch - kInside);
    if (from > 0.0F && to > 0.0F)
      rise_[static_cast<std::size_t>(i) + 1] = 2.0F * (to - from) / (to + from) / kFar;
  }
  growth_.assign(static_cast<std::size_t>(count), 0.0F);
  for (std::size_t i = 0; i < growth_.size(); ++i)
  {
    const float here = rise_[i + 1];
    const float before = rise_[i] < kNone ? rise_[i] : here;
    const float after = rise_[i + 2] < kNone ? rise_[i + 2] : here;
    if (here < kNone && before * here > 0.0F && after * here > 0.0F)
      growth_[i] = std::copysign(std::min({ std::abs(before), std::abs(here), std::abs(after) }), here);
  }
}
}  // namespace weld_profiler
