#pragma once

#include "column_track.h"
#include "weld_profiler/core/image.h"

namespace weld_profiler
{
/// Measures the stripe in every column about the track's reference line, eight columns at once.
///
/// With z = (row - v) / sigma and t = 1 - z^2 / 16: t^6 is a Gaussian of the stripe's width that ends at four of them,
/// and z t^6 within 0.5 % the weight that noise allows at best for a centre, from read noise alone to as much shot
/// noise again (z g / var, g the stripe's profile). z (1 - t)^2 t^5 looks at the flanks, at 1.5 to 3 half widths: the
/// best weight where speckle, noise in proportion to the light, is what disturbs.
///
/// For a Gaussian weight the offset that a reflectance A(s) along an oblique stripe feigns is exactly
/// sigma^2 slope / (1 + slope^2) d ln(light) / du, whatever A: AlongStripe takes it off.
class ColumnMoments
{
public:
  /// Fills light, core, flanks, spread, peak and weight (0 or 1) of every column of the track's pieces.
  /// @param noise  1-sigma of one pixel [grey levels].
  static void measure(const ImageView& image, float noise, ColumnTrack& track);

  /// The same without flanks and peak, for a first look.
  static void locate(const ImageView& image, float noise, ColumnTrack& track);

private:
  template <bool kWhole>
  static void run(const ImageView& image, float noise, ColumnTrack& track);
};
}  // namespace weld_profiler
