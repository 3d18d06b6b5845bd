#pragma once

#include <opencv2/core/mat.hpp>

#include "weld_profiler/core/image.h"
#include "weld_profiler/core/stripe.h"
#include "weld_profiler/stripe/workspace.h"

namespace weld_profiler
{
/// Draws what was found on the image in the colours of the paper's Fig. 7: pixel blocks yellow, initial points red,
/// exact points blue, interpolated points green, the curve red, normals white.
/// @param initial  Workspace::initial, or empty.
/// @param scale    enlargement; normals and blocks are legible from 4 on. 1..16
/// @return BGR, 8 bit, scale times the image's size.
cv::Mat drawStripe(const RawImage& image, const Stripe& stripe, const std::vector<InitialPoint>& initial,
                   int scale = 1);
}  // namespace weld_profiler
