#pragma once

#include <cstdint>
#include <vector>

#include "pixels.h"

namespace weld_profiler
{
/// The paper's median filter (section 2.2) against pepper noise, size x size pixels; the border is repeated.
///
/// The literal reading alone looks at the result: a median flattens the stripe's top, and derivatives taken from it
/// push every centre to the end of its pixel.
/// @param size    3 or 5; 0 = copy.
/// @param memory  holds the result, reused.
void medianFilter(const ImageView& image, int size, std::vector<std::uint8_t>& memory, ImageView& filtered);
}  // namespace weld_profiler
