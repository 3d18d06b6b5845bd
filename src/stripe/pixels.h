#pragma once

#include <algorithm>
#include <cstdint>

#include "weld_profiler/core/image.h"
#include "weld_profiler/stripe/stripe_params.h"

namespace weld_profiler
{
/// Calls use(Pixel{}) with the image's pixel type, so that a step is written once for 8 and 16 bit.
template <class Use>
decltype(auto) withPixel(const ImageView& image, Use&& use)
{
  return image.bit_depth == 8 ? use(std::uint8_t{}) : use(std::uint16_t{});
}

/// What the grey levels of an image mean.
struct Levels
{
  double saturation = 255.0;  ///< pixels from here on are clipped
  double count = 1.0;         ///< one grey level of an 8-bit image [DN8], in levels of this image

  /// Levels to one bin of a histogram of 256 bins.
  double bin() const { return (saturation + 1.0) / 256.0; }
};

inline Levels levelsOf(const ImageView& image, const StripeParams& params)
{
  Levels levels;
  const double largest = image.bit_depth == 8 ? 255.0 : 65535.0;
  levels.saturation = params.saturation_level > 0.0 ? std::min(params.saturation_level, largest) : largest;
  levels.count = image.bit_depth == 8 ? 1.0 : levels.saturation / 255.0;
  return levels;
}
}  // namespace weld_profiler
