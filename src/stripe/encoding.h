#pragma once

#include <string>

#include "weld_profiler/core/image.h"

namespace weld_profiler
{
/// How the pixels of one ROS encoding lie in memory.
struct Encoding
{
  enum class Kind
  {
    Mono,
    Colour,  ///< interleaved
    Bayer
  };

  const char* name = "";
  Kind kind = Kind::Mono;
  int bits = 8;  ///< a channel
  int channels = 1;
  int red = 0, blue = 0;  ///< index of the channel; Bayer: place of the photosite in its 2x2 block, 2 * row + column

  int bytesPerPixel() const { return bits / 8 * channels; }
};

/// @throws PreconditionError for a name that is not known, listing those that are.
const Encoding& findEncoding(const std::string& name);

/// @throws PreconditionError for a step too short for the image's columns or not of whole samples.
void checkStep(const RawImage& image, const Encoding& encoding);
}  // namespace weld_profiler
