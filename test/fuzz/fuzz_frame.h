#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>

#include "fuzz/bytes.h"
#include "weld_profiler/core/image.h"

namespace weld_profiler
{
namespace fuzz
{
/// What an image shows; all of it at once, any part may be absent. Grey levels of 8 bit, clipped when drawn.
struct Picture
{
  struct Line
  {
    double row = 0.0, slope = 0.0, bend = 0.0, sigma = 1.0, peak = 0.0;
    double period = 0.0;  ///< of its brightness [px], 0 = even
    int gap_first = 0, gap_last = -1;
  };
  struct Spot
  {
    int u = 0, v = 0, radius = 0;
    double level = 0.0;
  };

  double level = 0.0, ramp_u = 0.0, ramp_v = 0.0;
  int square = 0;  ///< of a checkerboard [px], 0 = none
  double contrast = 0.0;
  double noise = 0.0;
  std::uint32_t seed = 1;
  int lines = 0, spots = 0;
  std::array<Line, 4> line;
  std::array<Spot, 8> spot;
  bool upright = false;  ///< columns and rows change places

  double at(double u, double v) const;
};

Picture readPicture(Bytes& bytes);

/// How an image lies in memory.
struct Layout
{
  int width = 1, height = 1;
  std::string encoding = "mono8";
  bool big_endian = false;
  int padding = 0;  ///< bytes after each row; negative = a step that is too short
};

Layout readLayout(Bytes& bytes);

/// An image in memory of exactly the size its description promises: a sanitizer sees what is read beyond it.
class Frame
{
public:
  Frame(const Layout& layout, const Picture& picture);
  /// Every byte straight from the fuzzer, repeated.
  Frame(const Layout& layout, Bytes& bytes);

  const RawImage& image() const { return image_; }

private:
  std::size_t allocate(const Layout& layout);

  std::unique_ptr<std::uint8_t[]> pixels_;
  RawImage image_;
  int channels_ = 1, bits_ = 8;
};
}  // namespace fuzz
}  // namespace weld_profiler
