#pragma once

#include <cstdint>
#include <vector>

#include "pixels.h"

namespace weld_profiler
{
/// The paper's median filter (section 2.2) against pepper noise, size x size pixels; the border is repeated.
///
/// In the sound reading only detection looks at the result: a median flattens the stripe's top, and derivatives taken
/// from it push every centre to the end of its pixel.
/// @param size    3 or 5; 0 = copy.
/// @param memory  holds the result, reused.
void medianFilter(const ImageView& image, int size, std::vector<std::uint8_t>& memory, ImageView& filtered);

/// The same result in chosen tiles only: filtering a whole frame takes longer than all other steps together.
class TiledMedian
{
public:
  static constexpr int kTileRows = 8;
  static constexpr int kTileColumns = 64;

  /// Begins a frame: nothing is filtered yet.
  void reset(const ImageView& image, int size);
  /// Asks for the tile that holds rows [8 tile_row, 8 tile_row + 8) around column u.
  void request(int u, int tile_row);
  /// Filters what was asked for.
  void filter();
  /// Valid in the tiles asked for only.
  const ImageView& filtered() const { return filtered_; }

private:
  /// Pixels [u, u + width) of rows [v, v + height).
  struct Span
  {
    int u, v, width, height;
  };

  void filterSpan(int tile_row, int first_tile, int last_tile);
  template <class Pixel>
  void filterSpan3(const Span& span);
  template <class Pixel>
  void filterSpan5(const Span& span);

  ImageView image_;
  ImageView filtered_;
  int size_ = 0;
  int tiles_u_ = 0;
  int tiles_v_ = 0;
  std::vector<std::uint8_t> requested_;
  std::vector<std::uint8_t> memory_;
  std::vector<std::uint8_t> sorted_;  ///< scratch of one span
};
}  // namespace weld_profiler
