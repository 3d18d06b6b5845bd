#pragma once

#include <array>
#include <cstdint>

#include "pixels.h"

namespace weld_profiler
{
constexpr int kBins = 256;
using Histogram = std::array<std::uint32_t, kBins>;

/// What a frame looks like as a whole, from a sample of its columns.
struct FrameStatistics
{
  Histogram histogram{};         ///< grey levels, in bins of Levels::bin()
  double background = 0.0;       ///< grey level of what is not stripe
  double saturated_share = 0.0;  ///< of all pixels, 0..1
  double otsu = 0.0;             ///< Otsu's threshold [grey levels]
};

/// Samples whole columns: a stripe along the rows is met at its true share, however thin.
void measureFrame(const ImageView& image, const Levels& levels, FrameStatistics& statistics);
}  // namespace weld_profiler
