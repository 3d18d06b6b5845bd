#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace weld_profiler
{
/// A grey image somebody else owns: what stripe extraction reads. Pixel centres lie at integers.
struct ImageView
{
  const std::uint8_t* data = nullptr;
  int width = 0;         ///< columns [px]
  int height = 0;        ///< rows [px]
  std::size_t step = 0;  ///< bytes from one row to the next
  int bit_depth = 8;     ///< of the container: 8 or 16 (host byte order)

  bool empty() const { return data == nullptr || width <= 0 || height <= 0; }

  template <class Pixel>
  const Pixel* row(int v) const
  {
    return reinterpret_cast<const Pixel*>(data + static_cast<std::size_t>(v) * step);
  }
};

/// An image as a camera or a file delivers it, in one of the ROS encodings (mono8, mono16, rgb8, bayer_rggb8, ...).
struct RawImage
{
  const std::uint8_t* data = nullptr;
  int width = 0;
  int height = 0;
  std::size_t step = 0;
  std::string encoding;     ///< name as in sensor_msgs/image_encodings
  bool big_endian = false;  ///< byte order of 16-bit pixels
};
}  // namespace weld_profiler
