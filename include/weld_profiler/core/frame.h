#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "weld_profiler/core/image.h"
#include "weld_profiler/core/stamp.h"

namespace weld_profiler
{
/// One image with its memory, as a FrameSource hands it over. `pixels` is what a sensor_msgs/Image holds in `data`,
/// so that a nodelet moves it into the message without a copy.
struct Frame
{
  std::vector<std::uint8_t> pixels;
  int width = 0;
  int height = 0;
  std::size_t step = 0;
  std::string encoding;
  Stamp stamp = 0;           ///< middle of the exposure
  std::uint64_t number = 0;  ///< the driver's frame counter; a gap = frames lost
  double exposure = 0.0;     ///< [s], 0 = unknown
  std::string origin;        ///< file name or device address, for messages

  RawImage view() const { return RawImage{ pixels.data(), width, height, step, encoding, false }; }
};
}  // namespace weld_profiler
