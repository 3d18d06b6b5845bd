#include "fuzz/fuzz_frame.h"

#include <cmath>
#include <vector>

namespace weld_profiler
{
namespace fuzz
{
namespace
{
constexpr int kLargest = 300;  ///< px either way
constexpr const char* kEncodings[] = { "mono8",        "mono16",       "rgb8",         "bgr8",        "rgba8",
                                       "bgra8",        "rgb16",        "bgr16",        "rgba16",      "bgra16",
                                       "bayer_rggb8",  "bayer_bggr8",  "bayer_gbrg8",  "bayer_grbg8", "bayer_rggb16",
                                       "bayer_bggr16", "bayer_gbrg16", "bayer_grbg16", "32FC1",       "" };

bool startsWith(const std::string& text, const char* start)
{
  return text.rfind(start, 0) == 0;
}

int channelsOf(const std::string& encoding)
{
  if (startsWith(encoding, "rgba") || startsWith(encoding, "bgra"))
    return 4;
  return startsWith(encoding, "rgb") || startsWith(encoding, "bgr") ? 3 : 1;
}

bool isWide(const std::string& encoding)
{
  return encoding.size() > 1 && encoding.compare(encoding.size() - 2, 2, "16") == 0;
}

Picture::Line readLine(Bytes& bytes)
{
  Picture::Line line;
  line.row = bytes.real(-20.0, bytes.oneIn(3) ? kLargest : 80.0);
  line.slope = bytes.oneIn(2) ? bytes.real(-3.0, 3.0) : 0.0;
  line.bend = bytes.oneIn(3) ? bytes.real(-0.1, 0.1) : 0.0;
  line.sigma = bytes.real(0.1, bytes.oneIn(3) ? 25.0 : 4.0);
  line.peak = bytes.real(0.0, bytes.oneIn(4) ? 2000.0 : 250.0);
  line.period = bytes.oneIn(4) ? bytes.real(1.0, 60.0) : 0.0;
  if (bytes.oneIn(2))
  {
    line.gap_first = bytes.between(0, kLargest);
    line.gap_last = line.gap_first + bytes.between(0, 40);
  }
  return line;
}

/// A value of the noise in [-1, 1] that depends on nothing but the pixel and the seed.
double hash(std::uint32_t seed, int u, int v)
{
  std::uint32_t x =
      seed * 0x9E3779B9U + static_cast<std::uint32_t>(u) * 0x85EBCA6BU + static_cast<std::uint32_t>(v) * 0xC2B2AE35U;
  x = (x ^ (x >> 15U)) * 0x2C1B3C6DU;
  x = (x ^ (x >> 12U)) * 0x297A2D39U;
  x ^= x >> 15U;
  return x / 2147483647.5 - 1.0;
}
}  // namespace

double Picture::at(double u, double v) const
{
  if (upright)
    std::swap(u, v);
  const int column = static_cast<int>(u);
  const int row = static_cast<int>(v);
  double value = level + ramp_u * u + ramp_v * v;
  if (square > 0)
    value += (column / square + row / square) % 2 == 0 ? contrast : -contrast;
  for (int i = 0; i < lines; ++i)
  {
    const Line& l = line[static_cast<std::size_t>(i)];
    if (column >= l.gap_first && column <= l.gap_last)
      continue;
    const double middle = l.row + l.slope * u + l.bend * (u - 100.0) * (u - 100.0) / 10.0;
    const double gain = l.period > 0.0 ? 1.0 + std::sin(6.2832 * u / l.period) : 1.0;
    value += gain * l.peak * std::exp(-0.5 * std::pow((v - middle) / l.sigma, 2.0));
  }
  for (int i = 0; i < spots; ++i)
  {
    const Spot& s = spot[static_cast<std::size_t>(i)];
    if (std::abs(column - s.u) <= s.radius && std::abs(row - s.v) <= s.radius)
      value += s.level;
  }
  return value + noise * hash(seed, column, row);
}

Picture readPicture(Bytes& bytes)
{
  Picture picture;
  picture.lines = bytes.between(0, 4) % 4;
  for (int i = 0; i < picture.lines; ++i)
    picture.line[static_cast<std::size_t>(i)] = readLine(bytes);
  picture.upright = bytes.oneIn(3);
  picture.level = bytes.oneIn(4) ? bytes.real(-300.0, 600.0) : bytes.real(0.0, 20.0);
  picture.noise = bytes.oneIn(3) ? bytes.real(0.0, 300.0) : bytes.real(0.0, 5.0);
  picture.seed = static_cast<std::uint32_t>(bytes.between(0, 65535));
  if (bytes.oneIn(3))
  {
    picture.ramp_u = bytes.real(-2.0, 2.0);
    picture.ramp_v = bytes.real(-2.0, 2.0);
  }
  if (bytes.oneIn(4))
  {
    picture.square = bytes.between(1, 40);
    picture.contrast = bytes.real(0.0, 300.0);
  }
  picture.spots = bytes.oneIn(3) ? bytes.between(0, 8) : 0;
  for (int i = 0; i < picture.spots; ++i)
  {
    Picture::Spot& spot = picture.spot[static_cast<std::size_t>(i)];
    spot.u = bytes.between(0, kLargest);
    spot.v = bytes.between(0, kLargest);
    spot.radius = bytes.between(0, 20);
    spot.level = bytes.real(-300.0, 600.0);
  }
  return picture;
}

Layout readLayout(Bytes& bytes)
{
  Layout layout;
  const int largest = bytes.oneIn(4) ? kLargest : 80;
  layout.width = bytes.oneIn(16) ? bytes.between(0, 4) : bytes.between(0, largest);
  layout.height = bytes.oneIn(16) ? bytes.between(0, 4) : bytes.between(0, largest);
  layout.encoding = bytes.oneIn(2) ? "mono8" : bytes.pick(kEncodings);
  layout.big_endian = bytes.oneIn(3);
  layout.padding = bytes.oneIn(4) ? bytes.between(-2, 40) : 0;
  return layout;
}

/// @return bytes of the image.
std::size_t Frame::allocate(const Layout& layout)
{
  bits_ = isWide(layout.encoding) ? 16 : 8;
  channels_ = channelsOf(layout.encoding);
  const int row = layout.width * channels_ * (bits_ / 8);
  image_.width = layout.width;
  image_.height = layout.height;
  image_.step = static_cast<std::size_t>(std::max(0, row + layout.padding));
  image_.encoding = layout.encoding;
  image_.big_endian = layout.big_endian;
  // The last row's padding may be missing, as in a region of a larger image.
  const std::size_t size =
      layout.height > 0 ? image_.step * static_cast<std::size_t>(layout.height - 1) + static_cast<std::size_t>(row) : 0;
  pixels_ = std::make_unique<std::uint8_t[]>(size);
  image_.data = pixels_.get();
  return size;
}

Frame::Frame(const Layout& layout, const Picture& picture)
{
  const std::size_t size = allocate(layout);
  for (int v = 0; v < layout.height; ++v)
    for (int u = 0; u < layout.width; ++u)
    {
      const double share = std::clamp(picture.at(u, v) / 255.0, 0.0, 1.0);
      for (int c = 0; c < channels_; ++c)
      {
        const std::size_t at =
            image_.step * static_cast<std::size_t>(v) + static_cast<std::size_t>((u * channels_ + c) * (bits_ / 8));
        if (at + static_cast<std::size_t>(bits_ / 8) > size)
          continue;  // of a step that is too short
        const auto level = static_cast<unsigned>(share * (bits_ == 8 ? 255.0 : 65535.0));
        const unsigned high = level >> 8U, low = level & 0xFFU;
        pixels_[at] = static_cast<std::uint8_t>(bits_ == 16 && layout.big_endian ? high : low);
        if (bits_ == 16)
          pixels_[at + 1] = static_cast<std::uint8_t>(layout.big_endian ? low : high);
      }
    }
}

Frame::Frame(const Layout& layout, Bytes& bytes)
{
  const std::size_t size = allocate(layout);
  std::vector<std::uint8_t> pattern(static_cast<std::size_t>(bytes.between(1, 255)));
  for (std::uint8_t& value : pattern)
    value = bytes.next();
  for (std::size_t i = 0; i < size; ++i)
    pixels_[i] = pattern[i % pattern.size()];
}
}  // namespace fuzz
}  // namespace weld_profiler
