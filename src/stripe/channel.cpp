#include "channel.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "encoding.h"

namespace weld_profiler
{
namespace
{
/// Reads samples of one depth and byte order.
template <class Pixel, bool kSwap>
struct Sample
{
  static Pixel at(const std::uint8_t* row, std::ptrdiff_t index)
  {
    const Pixel value = reinterpret_cast<const Pixel*>(row)[index];
    return kSwap ? static_cast<Pixel>((value >> 8) | (value << 8)) : value;
  }
};

bool hostIsBigEndian()
{
  const std::uint16_t probe = 1;
  return *reinterpret_cast<const std::uint8_t*>(&probe) == 0;
}

/// Calls use(Pixel{}, Sample<...>{}).
template <class Use>
void withSamples(int bits, bool swap, Use&& use)
{
  if (bits == 8)
    use(std::uint8_t{}, Sample<std::uint8_t, false>{});
  else if (swap)
    use(std::uint16_t{}, Sample<std::uint16_t, true>{});
  else
    use(std::uint16_t{}, Sample<std::uint16_t, false>{});
}

/// A packed view in memory.
ImageView packed(int width, int height, int bits, std::vector<std::uint8_t>& memory)
{
  ImageView view;
  view.width = width;
  view.height = height;
  view.bit_depth = bits;
  view.step = static_cast<std::size_t>(width) * static_cast<std::size_t>(bits / 8);
  memory.resize(view.step * static_cast<std::size_t>(height));
  view.data = memory.data();
  return view;
}

/// Fills a packed view: value(v) gives for a row a function of the column.
template <class Pixel, class RowValue>
void fill(const ImageView& view, std::vector<std::uint8_t>& memory, RowValue&& row_value)
{
  for (int v = 0; v < view.height; ++v)
  {
    auto value = row_value(v);
    auto* out = reinterpret_cast<Pixel*>(memory.data() + static_cast<std::size_t>(v) * view.step);
    for (int u = 0; u < view.width; ++u)
      out[u] = value(u);
  }
}

const std::uint8_t* rawRow(const RawImage& image, int v)
{
  return image.data + static_cast<std::size_t>(v) * image.step;
}

ChannelView at(const Region& region)
{
  ChannelView result;
  result.cell_u = region.x;
  result.cell_v = region.y;
  result.u = region.x;
  result.v = region.y;
  return result;
}

ChannelView monoView(const RawImage& image, const Encoding& encoding, const Region& region, ChannelMemory& memory)
{
  ChannelView result = at(region);
  if (encoding.bits == 8 || image.big_endian == hostIsBigEndian())
  {
    result.view.data = rawRow(image, region.y) + static_cast<std::ptrdiff_t>(region.x) * encoding.bytesPerPixel();
    result.view.width = region.width;
    result.view.height = region.height;
    result.view.step = image.step;
    result.view.bit_depth = encoding.bits;
    return result;
  }
  result.view = packed(region.width, region.height, encoding.bits, memory.plane);
  fill<std::uint16_t>(result.view, memory.plane,
                      [&](int v)
                      {
                        const std::uint8_t* row = rawRow(image, region.y + v);
                        return [row, &region](int u) { return Sample<std::uint16_t, true>::at(row, region.x + u); };
                      });
  return result;
}

ChannelView colourView(const RawImage& image, const Encoding& encoding, const Region& region,
                       const std::string& channel, ChannelMemory& memory)
{
  ChannelView result = at(region);
  result.view = packed(region.width, region.height, encoding.bits, memory.plane);
  const std::ptrdiff_t count = encoding.channels;
  withSamples(encoding.bits, image.big_endian != hostIsBigEndian(),
              [&](auto pixel, auto sample)
              {
                using Pixel = decltype(pixel);
                const auto fillWith = [&](auto combine)
                {
                  fill<Pixel>(result.view, memory.plane,
                              [&](int v)
                              {
                                const std::uint8_t* row = rawRow(image, region.y + v);
                                return [row, count, first = region.x, combine, sample](int u)
                                {
                                  const std::ptrdiff_t index = (first + u) * count;
                                  return static_cast<Pixel>(
                                      combine([&](int c) { return static_cast<unsigned>(sample.at(row, index + c)); }));
                                };
                              });
                };
                const int red = encoding.red;
                const int blue = encoding.blue;
                if (channel == "max")
                  fillWith([](auto&& c) { return std::max({ c(0), c(1), c(2) }); });
                else if (channel == "luminance")
                  fillWith([red, blue](auto&& c) { return (299 * c(red) + 587 * c(1) + 114 * c(blue) + 500) / 1000; });
                else
                {
                  const int chosen = channel == "red" ? red : (channel == "blue" ? blue : 1);
                  fillWith([chosen](auto&& c) { return c(chosen); });
                }
              });
  return result;
}

/// How many values a pitch of 2 gives in `pixels`, if each needs `reach` of them.
int valuesIn(int pixels, int reach)
{
  return pixels < reach ? 0 : (pixels - reach) / 2 + 1;
}

/// The photosites of one colour; of green the mean of the two in a block.
ChannelView photosites(const RawImage& image, const Encoding& encoding, const Region& region,
                       const std::string& channel, ChannelMemory& memory)
{
  const bool green = channel == "green";
  const int site = channel == "blue" ? encoding.blue : encoding.red;
  const int site_u = green ? 0 : site % 2;
  const int site_v = green ? 0 : site / 2;
  const int first_u = region.x + (region.x % 2 != site_u ? 1 : 0);
  const int first_v = region.y + (region.y % 2 != site_v ? 1 : 0);
  const int reach = green ? 2 : 1;  // pixels of a row that one value needs
  ChannelView result;
  result.pitch = 2;
  result.cell_u = first_u;
  result.cell_v = first_v;
  result.u = first_u + (green ? 0.5 : 0.0);
  result.v = first_v + (green ? 0.5 : 0.0);
  const int width = valuesIn(region.x + region.width - first_u, reach);
  const int height = valuesIn(region.y + region.height - first_v, reach);
  result.view = packed(width, height, encoding.bits, memory.plane);
  // In a block with red on the main diagonal green lies on the other.
  const int green_u = site == 0 || site == 3 ? 1 : 0;
  withSamples(encoding.bits, image.big_endian != hostIsBigEndian(),
              [&](auto pixel, auto sample)
              {
                using Pixel = decltype(pixel);
                fill<Pixel>(result.view, memory.plane,
                            [&](int v)
                            {
                              const std::uint8_t* row = rawRow(image, first_v + 2 * v);
                              const std::uint8_t* next = green ? row + image.step : row;
                              return [=](int u)
                              {
                                const std::ptrdiff_t index = first_u + 2 * u;
                                if (!green)
                                  return sample.at(row, index);
                                return static_cast<Pixel>(
                                    (sample.at(row, index + green_u) + sample.at(next, index + 1 - green_u) + 1) / 2);
                              };
                            });
              });
  return result;
}

/// `max` and `luminance` of a Bayer image, from all three colours interpolated at every pixel.
ChannelView interpolated(const RawImage& image, const Encoding& encoding, const Region& asked,
                         const std::string& channel, ChannelMemory& memory)
{
  constexpr int kLeast = 4;  // pixels that interpolation needs
  if (image.width < kLeast || image.height < kLeast)
    return monoView(image, encoding, asked, memory);
  // From the corner of a 2x2 block on, and not too small to interpolate.
  Region region = asked;
  region.x = std::min(asked.x, image.width - kLeast) / 2 * 2;
  region.y = std::min(asked.y, image.height - kLeast) / 2 * 2;
  region.width = std::max(kLeast, asked.x + asked.width - region.x);
  region.height = std::max(kLeast, asked.y + asked.height - region.y);
  const ImageView mosaic = monoView(image, encoding, region, memory).view;
  const int type = encoding.bits == 8 ? CV_8U : CV_16U;
  const std::size_t bytes = static_cast<std::size_t>(encoding.bits / 8);
  memory.colour.resize(3 * bytes * static_cast<std::size_t>(region.width) * static_cast<std::size_t>(region.height));
  cv::Mat source(region.height, region.width, type, const_cast<std::uint8_t*>(mosaic.data), mosaic.step);
  cv::Mat result(region.height, region.width, CV_MAKETYPE(type, 3), memory.colour.data());
  // OpenCV names a mosaic by the colours of its second row's second and third pixel; index: where red lies.
  const int codes[] = { cv::COLOR_BayerBG2BGR, cv::COLOR_BayerGB2BGR, cv::COLOR_BayerGR2BGR, cv::COLOR_BayerRG2BGR };
  cv::cvtColor(source, result, codes[encoding.red]);
  RawImage colour;
  colour.data = memory.colour.data();
  colour.width = region.width;
  colour.height = region.height;
  colour.step = result.step;
  colour.encoding = encoding.bits == 8 ? "bgr8" : "bgr16";
  colour.big_endian = hostIsBigEndian();
  const Region whole{ 0, 0, region.width, region.height };
  ChannelView view = at(asked);
  view.view = colourView(colour, findEncoding(colour.encoding), whole, channel, memory).view;
  view.view.data += static_cast<std::size_t>(asked.y - region.y) * view.view.step +
                    static_cast<std::size_t>(asked.x - region.x) * bytes;
  view.view.width = asked.width;
  view.view.height = asked.height;
  return view;
}

}  // namespace

ChannelView selectChannel(const RawImage& image, const Region& region, const std::string& channel,
                          ChannelMemory& memory)
{
  const Encoding& encoding = findEncoding(image.encoding);
  checkStep(image, encoding);
  switch (encoding.kind)
  {
    case Encoding::Kind::Colour:
      return colourView(image, encoding, region, channel, memory);
    case Encoding::Kind::Bayer:
      return channel == "max" || channel == "luminance" ? interpolated(image, encoding, region, channel, memory)
                                                        : photosites(image, encoding, region, channel, memory);
    default:
      return monoView(image, encoding, region, memory);
  }
}
}  // namespace weld_profiler
