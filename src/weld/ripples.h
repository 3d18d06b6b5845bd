#pragma once

#include <vector>

#include "weld_profiler/weld/quantity.h"

namespace weld_profiler
{
namespace weld
{
struct Ripples
{
  Quantity pitch;   ///< [m]; not measured = none beyond doubt
  Quantity height;  ///< crest to trough [m]
};

/// The strongest wave along the weld: the median over stretches of 15 mm of the sine that explains most of the crest's
/// heights about their smooth course, where it explains a third of them and rises above their noise.
/// @param s       of each height, rising [m].
/// @param height  of the face's middle above the chord; NaN = not measured [m].
/// @param noise   1-sigma of a height [m].
Ripples findRipples(const std::vector<double>& s, const std::vector<double>& height, double noise);
}  // namespace weld
}  // namespace weld_profiler
