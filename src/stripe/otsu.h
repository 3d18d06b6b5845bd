#pragma once

#include "frame_statistics.h"

namespace weld_profiler
{
/// The bin that best parts a histogram in two: bins above it are stripe. The variance between the classes is largest.
///
/// Source: N. Otsu, "A threshold selection method from gray-level histograms", IEEE Trans. SMC 9(1), 1979 (the paper's
/// reference [17]). Poor for: glow, and stripes a few noise sigmas high: what it finds then is not the stripe, which is
/// why the literal reading alone asks for it.
/// @return 0..255; of several equal maxima the first; 0 for an empty histogram or one of a single bin.
int otsuBin(const Histogram& histogram);
}  // namespace weld_profiler
