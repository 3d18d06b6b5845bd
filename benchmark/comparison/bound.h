#pragma once

#include <map>
#include <vector>

namespace weld_profiler
{
namespace comparison
{
/// What the noise of the renderer does to one pixel, and a straight Gaussian stripe in it.
struct BoundSettings
{
  double sigma = 2.0;                                               ///< across the stripe [px]
  double slope = 0.0;                                               ///< dv/du
  double peak = 200.0, background = 8.0, snr = 50.0, clip = 255.0;  ///< as in StripePicture
};

/// Cramer-Rao lower bound of a stripe's place across itself, for the renderer's noise as it is: normal, half read and
/// half shot noise in variance, rounded to whole grey levels, clipped at 0 and at full scale.
class Bound
{
public:
  explicit Bound(const BoundSettings& settings);

  /// Fisher information that one pixel's grey level carries about the light in it. [1/DN^2]
  /// Exact: the sum of (dp/dlight)^2 / p over the grey levels it can show.
  double pixelInformation(double light) const;

  /// 1-sigma bound from all pixels of some neighbouring columns, centred on the point, of a straight stripe whose
  /// offset and slope are both unknown (of one column: the offset alone). [px]
  /// Peak, background and width cost nothing beside: by symmetry they are not correlated with the place.
  double ofColumns(int columns) const;

private:
  double informationAt(double light) const;
  double computeOfColumns(int columns) const;

  BoundSettings settings_;
  std::vector<double> table_;            ///< pixelInformation from no light to the peak
  mutable std::map<int, double> known_;  ///< by columns
};
}  // namespace comparison
}  // namespace weld_profiler
