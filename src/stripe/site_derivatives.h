#pragma once

#include <vector>

#include "band_tiles.h"
#include "derivatives.h"

namespace weld_profiler
{
/// DerivativeKernel::at() of many pixels at once, in single precision: down the columns of a row's neighbourhood first,
/// then along it, so that neighbours share the work. Differs from at() by rounding, some 1e-6 of the grey levels.
class SiteDerivatives
{
public:
  /// @param sites  the kernel holds each of them.
  void measure(const ImageView& image, const DerivativeKernel& kernel, const Sites& sites);

  /// One value a site.
  std::vector<float> x, y, xx, xy, yy;

  /// Of a run, down the columns: smoothed, first and second derivative; a value a column.
  struct Sums
  {
    float *smooth, *first, *second;
  };

private:
  Sums sumsOf(std::size_t run, int reach);
  void sumDown(const Sites& sites, const RowRun& run, int reach, const Sums& sums);
  void sumAlong(const Sites& sites, const RowRun& run, int reach, const Sums& sums);

  BandTiles tiles_;
  std::vector<float> factors_;  ///< smooth, first, second, one after the other
  std::vector<float> sums_;     ///< of all runs of a tile
};
}  // namespace weld_profiler
