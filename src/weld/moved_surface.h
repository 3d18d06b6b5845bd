#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include <Eigen/Geometry>

#include "scan_facets.h"

namespace weld_profiler
{
namespace weld
{
/// Places of a grid, seen from above, to be found by where they lie. The grid must outlive them.
class PlaceBins
{
public:
  /// @param wanted  one a point of the grid, 0 = leave it out; empty = all that are measured.
  PlaceBins(const ScanGrid& grid, const std::vector<std::uint8_t>& wanted);

  const ScanGrid& grid() const { return grid_; }

  /// Calls visit(index, x, y) for each place within a box (and a few around it).
  template <class Visit>
  void within(double x_from, double x_to, double y_from, double y_to, Visit&& visit) const
  {
    const int left = column(x_from), right = column(x_to), near = row(y_from), far = row(y_to);
    for (int r = near; r <= far; ++r)
    {
      for (int c = left; c <= right; ++c)
      {
        const auto bin = static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(c);
        for (std::size_t i = first_[bin]; i < first_[bin + 1]; ++i)
          visit(places_[i]);
      }
    }
  }

private:
  int column(double x) const;
  int row(double y) const;

  const ScanGrid& grid_;
  double left_ = 0.0, near_ = 0.0, size_ = 1.0;  ///< [m]
  int columns_ = 1, rows_ = 1;
  std::vector<std::size_t> first_;  ///< of each bin, and one more
  std::vector<std::uint32_t> places_;
};

/// Variance of a point's z, as it says itself [m^2].
double pointVariance(const ScanGrid& grid, std::size_t i);

/// A surface at a place.
struct SurfaceSample
{
  float z = std::numeric_limits<float>::quiet_NaN();  ///< NaN = not known [m]
  float variance = 0.0F;                              ///< of z [m^2]
  float slope_x = 0.0F, slope_y = 0.0F;               ///< dz/dx, dz/dy
};

/// A scan's surface, to be moved and sampled.
struct SurfaceView
{
  const ScanGrid& grid;
  const std::vector<Facet>& facets;
};

/// Heights of a moved surface over the places of another grid: linear within its facets, not known outside of them.
/// Where two facets lie over each other the upper one counts, which is what a sensor sees.
/// @param samples  one a point of the places' grid.
void sampleSurface(const SurfaceView& surface, const Eigen::Isometry3d& motion, const PlaceBins& places,
                   std::vector<SurfaceSample>& samples);
}  // namespace weld
}  // namespace weld_profiler
