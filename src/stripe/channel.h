#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "weld_profiler/core/image.h"

namespace weld_profiler
{
/// A rectangle of pixels of an image.
struct Region
{
  int x = 0, y = 0, width = 0, height = 0;
};

/// One grey channel of a region, and where its pixels lie in the image.
struct ChannelView
{
  ImageView view;
  int pitch = 1;               ///< pixels of the image from one pixel of the view to the next
  int cell_u = 0, cell_v = 0;  ///< column and row of the image that the view's first pixel belongs to
  double u = 0.0, v = 0.0;     ///< middle of the view's first pixel in the image [px]
};

/// Memory of selectChannel, reused from frame to frame.
struct ChannelMemory
{
  std::vector<std::uint8_t> plane;
  std::vector<std::uint8_t> colour;  ///< of a Bayer image whose colours had to be interpolated
};

/// Takes the channel `red`, `green`, `blue`, `max` or `luminance` (ITU-R BT.601) out of a region of the image.
///
/// Mono images are not copied: the view points at the caller's pixels (but for 16 bit of the other byte order), and the
/// channel's name means nothing. Bayer: `red` and `blue` are the photosites of that colour alone, every 2nd pixel of
/// every 2nd row; `green` the mean of the two of a 2x2 block, which lies in its middle; `max` and `luminance` are
/// interpolated at every pixel, and therefore modulated by the mosaic under a one-coloured stripe: a poor choice for a
/// laser.
/// @throws PreconditionError for an unknown encoding or a step too short for its columns or not of whole samples.
ChannelView selectChannel(const RawImage& image, const Region& region, const std::string& channel,
                          ChannelMemory& memory);
}  // namespace weld_profiler
