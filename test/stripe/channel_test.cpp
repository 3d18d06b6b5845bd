#include "stripe/channel.h"

#include <gtest/gtest.h>

#include "stripe/encoding.h"

namespace weld_profiler
{
namespace
{
/// An image whose samples are told by a function of (row, sample in the row).
struct Samples
{
  std::vector<std::uint8_t> bytes;
  RawImage image;

  template <class Value>
  Samples(const std::string& encoding, int width, int height, bool big_endian, Value&& value)
  {
    const Encoding& layout = findEncoding(encoding);
    image.width = width;
    image.height = height;
    image.encoding = encoding;
    image.big_endian = big_endian;
    image.step = static_cast<std::size_t>(width * layout.bytesPerPixel()) + 6;  // rows are padded
    bytes.assign(image.step * static_cast<std::size_t>(height), 0xEE);
    for (int v = 0; v < height; ++v)
      for (int i = 0; i < width * layout.channels; ++i)
      {
        const unsigned sample = value(v, i);
        std::uint8_t* at = bytes.data() + static_cast<std::size_t>(v) * image.step;
        if (layout.bits == 8)
          at[i] = static_cast<std::uint8_t>(sample);
        else
        {
          at[2 * i + (big_endian ? 0 : 1)] = static_cast<std::uint8_t>(sample >> 8);
          at[2 * i + (big_endian ? 1 : 0)] = static_cast<std::uint8_t>(sample & 0xFF);
        }
      }
    image.data = bytes.data();
  }
};

unsigned pixel(const ChannelView& channel, int u, int v)
{
  return channel.view.bit_depth == 8 ? channel.view.row<std::uint8_t>(v)[u] : channel.view.row<std::uint16_t>(v)[u];
}

const Region kWhole{ 0, 0, 12, 10 };

TEST(Channel, OfAMonoImagePointsAtTheCallersPixels)
{
  const Samples samples("mono8", 12, 10, false, [](int v, int u) { return 20 * v + u; });
  ChannelMemory memory;
  const ChannelView channel = selectChannel(samples.image, Region{ 3, 2, 5, 4 }, "red", memory);
  EXPECT_EQ(channel.view.data, samples.bytes.data() + 2 * samples.image.step + 3);
  EXPECT_EQ(channel.view.step, samples.image.step);
  EXPECT_EQ(channel.view.width, 5);
  EXPECT_EQ(channel.view.height, 4);
  EXPECT_EQ(channel.u, 3.0);
  EXPECT_EQ(channel.v, 2.0);
}

TEST(Channel, OfSixteenBitsIsTheSameInEitherByteOrder)
{
  const auto value = [](int v, int u) { return 5000U + 321U * static_cast<unsigned>(v) + static_cast<unsigned>(u); };
  for (const bool big_endian : { false, true })
  {
    const Samples samples("mono16", 12, 10, big_endian, value);
    ChannelMemory memory;
    const ChannelView channel = selectChannel(samples.image, kWhole, "red", memory);
    ASSERT_EQ(channel.view.bit_depth, 16);
    EXPECT_EQ(pixel(channel, 0, 0), 5000U);
    EXPECT_EQ(pixel(channel, 7, 9), value(9, 7));
  }
}

struct ColourCase
{
  const char* encoding;
  int channels, red, green, blue;
};

TEST(Channel, OfEveryColourEncodingIsTheOneAskedFor)
{
  const ColourCase cases[] = { { "rgb8", 3, 0, 1, 2 },   { "bgr8", 3, 2, 1, 0 },  { "rgba8", 4, 0, 1, 2 },
                               { "bgra8", 4, 2, 1, 0 },  { "rgb16", 3, 0, 1, 2 }, { "bgr16", 3, 2, 1, 0 },
                               { "rgba16", 4, 0, 1, 2 }, { "bgra16", 4, 2, 1, 0 } };
  for (const ColourCase& c : cases)
    for (const bool big_endian : { false, true })
    {
      const Samples samples(c.encoding, 12, 10, big_endian,
                            [&](int, int i)
                            {
                              return i % c.channels == c.red
                                         ? 200U
                                         : (i % c.channels == c.green ? 100U : (i % c.channels == c.blue ? 50U : 255U));
                            });
      ChannelMemory memory;
      const auto look = [&](const char* name) {
        return pixel(selectChannel(samples.image, Region{ 5, 4, 6, 5 }, name, memory), 1, 1);
      };
      EXPECT_EQ(look("red"), 200U) << c.encoding;
      EXPECT_EQ(look("green"), 100U) << c.encoding;
      EXPECT_EQ(look("blue"), 50U) << c.encoding;
      EXPECT_EQ(look("max"), 200U) << c.encoding;
      EXPECT_EQ(look("luminance"), 124U) << c.encoding;  // 0.299 200 + 0.587 100 + 0.114 50 = 124.2
    }
}

struct BayerCase
{
  const char* name;
  int red_u, red_v;
};

TEST(Channel, OfABayerImageIsThePhotositesOfThatColourAlone)
{
  for (const BayerCase& c :
       { BayerCase{ "rggb", 0, 0 }, BayerCase{ "bggr", 1, 1 }, BayerCase{ "gbrg", 0, 1 }, BayerCase{ "grbg", 1, 0 } })
    for (const char* depth : { "8", "16" })
      for (const Region& region : { kWhole, Region{ 3, 1, 7, 8 }, Region{ 2, 5, 8, 5 } })
      {
        const Samples samples("bayer_" + std::string(c.name) + depth, 12, 10, false,
                              [&](int v, int u)
                              {
                                const bool red = u % 2 == c.red_u && v % 2 == c.red_v;
                                const bool blue = u % 2 != c.red_u && v % 2 != c.red_v;
                                return static_cast<unsigned>((red ? 0 : (blue ? 200 : 100)) + v * 5 + u);
                              });
        ChannelMemory memory;
        const ChannelView red = selectChannel(samples.image, region, "red", memory);
        ASSERT_EQ(red.pitch, 2);
        ASSERT_GE(red.view.width, 3);
        ASSERT_GE(red.view.height, 2);
        EXPECT_EQ(red.cell_u % 2, c.red_u);
        EXPECT_EQ(red.cell_v % 2, c.red_v);
        EXPECT_GE(red.cell_u, region.x);
        EXPECT_LE(red.cell_u + 2 * (red.view.width - 1), region.x + region.width - 1);
        EXPECT_LE(red.cell_v + 2 * (red.view.height - 1), region.y + region.height - 1);
        // No half-pixel shift: the view's pixel is the photosite itself.
        EXPECT_EQ(pixel(red, 2, 1), static_cast<unsigned>((red.cell_v + 2) * 5 + red.cell_u + 4)) << c.name;
        EXPECT_EQ(red.u, red.cell_u);
        const ChannelView blue = selectChannel(samples.image, region, "blue", memory);
        EXPECT_EQ(pixel(blue, 1, 1), static_cast<unsigned>(200 + (blue.cell_v + 2) * 5 + blue.cell_u + 2)) << c.name;
        const ChannelView green = selectChannel(samples.image, region, "green", memory);
        // The mean of the two green photosites of a block lies in its middle.
        const double middle = 100.0 + (green.v + 2.0) * 5.0 + green.u + 2.0;
        EXPECT_NEAR(pixel(green, 1, 1), middle, 0.51) << c.name;
      }
}

TEST(Channel, OfABayerImageMayBeInterpolatedAtEveryPixel)
{
  for (const BayerCase& c :
       { BayerCase{ "rggb", 0, 0 }, BayerCase{ "bggr", 1, 1 }, BayerCase{ "gbrg", 0, 1 }, BayerCase{ "grbg", 1, 0 } })
  {
    const Samples samples("bayer_" + std::string(c.name) + "8", 12, 10, false,
                          [&](int v, int u)
                          {
                            const bool red = u % 2 == c.red_u && v % 2 == c.red_v;
                            const bool blue = u % 2 != c.red_u && v % 2 != c.red_v;
                            return red ? 200U : (blue ? 50U : 100U);
                          });
    ChannelMemory memory;
    const ChannelView most = selectChannel(samples.image, Region{ 3, 3, 6, 5 }, "max", memory);
    EXPECT_EQ(most.pitch, 1);
    const ChannelView luminance = selectChannel(samples.image, kWhole, "luminance", memory);
    EXPECT_EQ(luminance.view.width, 12);
    for (int v = 2; v < 8; ++v)
      for (int u = 2; u < 10; ++u)
        EXPECT_EQ(pixel(luminance, u, v), 124U) << c.name;
  }
}

TEST(Channel, HasNoPhotositesInARegionTooNarrowForThem)
{
  const Samples samples("bayer_rggb8", 12, 10, false, [](int, int) { return 100U; });
  ChannelMemory memory;
  EXPECT_TRUE(selectChannel(samples.image, Region{ 3, 0, 1, 10 }, "red", memory).view.empty());
  EXPECT_TRUE(selectChannel(samples.image, Region{ 0, 3, 12, 1 }, "red", memory).view.empty());
  EXPECT_TRUE(selectChannel(samples.image, Region{ 2, 0, 1, 10 }, "blue", memory).view.empty());
  EXPECT_TRUE(selectChannel(samples.image, Region{ 2, 0, 1, 10 }, "green", memory).view.empty());
  EXPECT_EQ(selectChannel(samples.image, Region{ 2, 0, 1, 10 }, "red", memory).view.width, 1);
}

TEST(Channel, OfAnInterpolatedBayerImageIsTheRegionAskedForAndNoMore)
{
  const Samples samples("bayer_rggb16", 12, 10, false, [](int v, int u) { return 1000U + 20U * v + u; });
  ChannelMemory memory;
  for (const Region& region : { Region{ 5, 3, 6, 5 }, Region{ 11, 9, 1, 1 }, Region{ 9, 0, 2, 10 } })
    for (const char* name : { "max", "luminance" })
    {
      ChannelMemory whole_memory;
      const ChannelView whole = selectChannel(samples.image, kWhole, name, whole_memory);
      const ChannelView channel = selectChannel(samples.image, region, name, memory);
      ASSERT_EQ(channel.view.width, region.width);
      ASSERT_EQ(channel.view.height, region.height);
      EXPECT_EQ(channel.cell_u, region.x);
      EXPECT_EQ(channel.cell_v, region.y);
      // Three pixels from the region's own edges both interpolate from the same neighbours.
      if (region.width > 4)
      {
        EXPECT_EQ(pixel(channel, 3, 2), pixel(whole, region.x + 3, region.y + 2)) << name;
      }
    }
}
}  // namespace
}  // namespace weld_profiler
