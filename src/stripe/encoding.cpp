#include "encoding.h"

#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
namespace
{
using Kind = Encoding::Kind;

const Encoding kEncodings[] = {
  { "mono8", Kind::Mono, 8, 1, 0, 0 },          { "mono16", Kind::Mono, 16, 1, 0, 0 },
  { "rgb8", Kind::Colour, 8, 3, 0, 2 },         { "bgr8", Kind::Colour, 8, 3, 2, 0 },
  { "rgba8", Kind::Colour, 8, 4, 0, 2 },        { "bgra8", Kind::Colour, 8, 4, 2, 0 },
  { "rgb16", Kind::Colour, 16, 3, 0, 2 },       { "bgr16", Kind::Colour, 16, 3, 2, 0 },
  { "rgba16", Kind::Colour, 16, 4, 0, 2 },      { "bgra16", Kind::Colour, 16, 4, 2, 0 },
  { "bayer_rggb8", Kind::Bayer, 8, 1, 0, 3 },   { "bayer_bggr8", Kind::Bayer, 8, 1, 3, 0 },
  { "bayer_gbrg8", Kind::Bayer, 8, 1, 2, 1 },   { "bayer_grbg8", Kind::Bayer, 8, 1, 1, 2 },
  { "bayer_rggb16", Kind::Bayer, 16, 1, 0, 3 }, { "bayer_bggr16", Kind::Bayer, 16, 1, 3, 0 },
  { "bayer_gbrg16", Kind::Bayer, 16, 1, 2, 1 }, { "bayer_grbg16", Kind::Bayer, 16, 1, 1, 2 },
};
}  // namespace

const Encoding& findEncoding(const std::string& name)
{
  for (const Encoding& encoding : kEncodings)
    if (name == encoding.name)
      return encoding;
  std::string known;
  for (const Encoding& encoding : kEncodings)
    known += (known.empty() ? "" : ", ") + std::string(encoding.name);
  throw PreconditionError("image encoding is '" + name + "', must be one of: " + known);
}

void checkStep(const RawImage& image, const Encoding& encoding)
{
  const auto least = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(encoding.bytesPerPixel());
  if (image.step < least)
    throw PreconditionError("image step is " + std::to_string(image.step) + ", must be at least " +
                            std::to_string(least) + " for " + std::to_string(image.width) + " columns of " +
                            image.encoding);
  const auto sample = static_cast<std::size_t>(encoding.bits / 8);
  if (image.step % sample != 0)
    throw PreconditionError("image step is " + std::to_string(image.step) + ", must be a multiple of the " +
                            std::to_string(sample) + " bytes of a sample of " + image.encoding +
                            ": pad the rows to whole samples");
}
}  // namespace weld_profiler
