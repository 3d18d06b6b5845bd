#pragma once

#include <vector>

#include "centre.h"
#include "frame_statistics.h"
#include "seed.h"

namespace weld_profiler
{
/// What weighs a pixel in the centroid.
enum class CentroidWeight
{
  Gray,        ///< I: the traditional gray centroid
  SquaredGray  ///< I^2: Eq. 4
};

/// Gray centroid of each seed's column.
///
/// Eq. 4 of the paper, Yc = sum(I^2 y) / sum(I^2), in the sound reading: the background, level and slope, is taken off,
/// and the cross-section is a window of 3 sigma either side that is centred on the result and has soft ends. (A window
/// cut by a threshold follows the pixels: errors of 30 to 130 mpx.) Good for: matt surfaces; with white noise Eq. 4
/// reaches the bound of one column. Poor for: steep flanks whose brightness changes along the stripe, as every method
/// that looks at one column.
class ColumnCentroid
{
public:
  /// @param centres  one a seed at most, in the seeds' order; seeds too close to the image's edge or too dim are left
  /// out.
  void measure(const ImageView& image, const Levels& levels, const FrameStatistics& statistics, CentroidWeight weight,
               const std::vector<Seed>& seeds, std::vector<Centre>& centres);

private:
  template <class Pixel>
  void measureBackground(const ImageView& image, double fallback, std::vector<Centre>& centres);
  template <class Pixel>
  bool measureOne(const ImageView& image, const Levels& levels, double noise, CentroidWeight weight, Centre& centre);
  void evenOut(std::vector<Centre>& centres, double Centre::*field);

  std::vector<double> evened_;
  std::vector<double> window_;
};
}  // namespace weld_profiler
