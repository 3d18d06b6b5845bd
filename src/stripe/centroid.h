#pragma once

#include <array>
#include <vector>

#include "centre.h"
#include "pixels.h"
#include "slot_choice.h"
#include "stripe_limits.h"

namespace weld_profiler
{
/// What weighs a pixel in the centroid.
enum class CentroidWeight
{
  Gray,        ///< I: the traditional gray centroid
  SquaredGray  ///< I^2: Eq. 4
};

/// Gray centroid of each column of a track.
///
/// Eq. 4 of the paper, Yc = sum(I^2 y) / sum(I^2), in the sound reading: the background, level and slope, is taken off,
/// and the cross-section is a window of 3 sigma either side that is centred on the result and has soft ends. (A window
/// cut by a threshold follows the pixels: errors of 30 to 130 mpx.) Good for: matt surfaces; with white noise Eq. 4
/// reaches the bound of one column. Poor for: steep flanks whose brightness changes along the stripe, as every method
/// that looks at one column.
class ColumnCentroid
{
public:
  struct Task
  {
    const ImageView& image;
    StripeLimits limits;
    CentroidWeight weight;
  };

  /// Several columns at once. Those that are too dim, too narrow or wide, too close to the image's edge or whose
  /// centroid leaves the stripe have no light afterwards.
  void measure(const Task& task, const ColumnTrack& track);

  /// Of each slot; 0 = no centroid.
  const std::vector<float>& light() const { return arrays_[Light]; }

  /// @param centres  one a chosen slot.
  void write(const ColumnTrack& track, const SlotChoice& choice, float saturation, std::vector<Centre>& centres) const;

private:
  enum Array
  {
    Light,
    Shift,      // of the centroid from the track's line [px]
    Sigma,      // 1-sigma half width [px]
    Amplitude,  // above the background [grey levels]
    ReadSigma,  // of the centroid [px]
    Brightest,  // pixel of the window
    Arrays
  };
  std::array<std::vector<float>, Arrays> arrays_;
};
}  // namespace weld_profiler
