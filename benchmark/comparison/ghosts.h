#pragma once

#include "comparison/score.h"

namespace weld_profiler
{
namespace comparison
{
/// A weld in a frame of 1440x1080, SNR 50, with all that follows a stripe about: a second reflection 25 to 60 px away
/// that comes and goes and outshines the stripe over a third of its length, a broad glow that covers a tenth of the
/// frame, and 60 spatters of 1 to 5 px radius, half of them near the stripe, none upon it.
Sample ghostSample(unsigned seed);

/// The same weld, sigma 2 px, alone.
test_support::StripePicture weldScene(int width, int height);
}  // namespace comparison
}  // namespace weld_profiler
