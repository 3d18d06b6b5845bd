#pragma once

#include "support/render_stripe.h"

namespace weld_profiler
{
namespace test_support
{
/// A second way to draw the same stripe, that shares nothing with render() but the description: light is integrated
/// over each pixel's area, and the distance is the least to any of the short chords the centre line is cut into. No
/// noise, no speckle. Only for lines without jumps.
Picture renderIntegrated(const StripePicture& stripe);
}  // namespace test_support
}  // namespace weld_profiler
