#pragma once

#include "multiversion.h"
#include "pixels.h"

namespace weld_profiler
{
/// What a column must show to be the stripe's.
struct StripeLimits
{
  float least_light;  ///< height above the background [grey levels]
  float noise;        ///< 1-sigma of one pixel [grey levels]
  float saturation;   ///< grey level at which pixels clip
  float least_width;  ///< 1-sigma half width across the stripe [px]
  float most_width;   ///< [px]

  /// That a light's square times its half width must reach too.
  WELD_PROFILER_KERNEL float leastSquare() const
  {
    constexpr float kLightOverNoise = 4.0F;  // half the chance of one false column in 30 000
    return kLightOverNoise * noise * (kLightOverNoise * noise);
  }
};

inline StripeLimits limitsOf(const StripeParams& params, const Levels& levels, float noise)
{
  return StripeLimits{ static_cast<float>(params.min_peak_counts * levels.count), noise,
                       static_cast<float>(levels.saturation), static_cast<float>(params.min_stripe_width_px),
                       static_cast<float>(params.max_stripe_width_px) };
}
}  // namespace weld_profiler
