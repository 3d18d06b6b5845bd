#pragma once

#include <vector>

#include "group_path.h"
#include "path_track.h"
#include "pixels.h"
#include "weld_profiler/core/stripe.h"

namespace weld_profiler
{
/// Finds the stripe in a frame: sums of 8 columns in every n-th row, their peaks, the best path through the peaks, laid
/// over the columns. The rows are thinned as far as a stripe can not slip through; where that shows too little, every
/// row is read.
class StripeFinder
{
public:
  /// @param last   the stripe of the frame before, or null: only the rows around it are searched, and every second one
  /// of
  ///               the others looked at. Where the stripe is not found there whole, or something rises elsewhere, or
  ///               the stripe comes near the end of those rows, everything is searched. The result is the same.
  /// @param track  the stripe to a pixel or so; no pieces = no stripe.
  void find(const ImageView& image, float least_peak, const Stripe* last, ColumnTrack& track);

  float noise() const { return noise_; }  ///< 1-sigma of one background pixel [grey levels]

private:
  void look(const ImageView& image, int row_step, float least_peak);
  bool follow(const ImageView& image, int row_step, float least_peak, const Stripe& last);
  void choose(float least_peak, const RowRange& rows);
  float leastHeight(float least_peak) const;
  void measureNoise();
  float medianDifference(int rows, int groups) const;
  bool standsOut() const;

  GroupSums sums_;
  GroupPeaks peaks_;
  GroupPath path_;
  PathTrack laid_;
  std::vector<PathNode> nodes_;
  float noise_ = 0.0F;
};
}  // namespace weld_profiler
