#pragma once

#include <cstdint>
#include <vector>

#include "centre.h"
#include "pixels.h"

namespace weld_profiler
{
/// Gray values of one column around a centre, with the background under the stripe, level and slope, taken off.
struct GrayColumn
{
  int first_row = 0;
  std::vector<double> gray;           ///< from first_row downward [grey levels]
  std::vector<std::uint8_t> clipped;  ///< 1 where the pixel is saturated: at least as bright as gray tells

  int size() const { return static_cast<int>(gray.size()); }
};

/// Reads the rows from middle - half to middle + half, those outside the image left out.
/// @param middle  row of the window's middle; any integer.
void readColumn(const ImageView& image, const Levels& levels, const Centre& centre, int middle, int half,
                GrayColumn& column);
}  // namespace weld_profiler
