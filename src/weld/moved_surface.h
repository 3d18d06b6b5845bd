#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include <Eigen/Geometry>

#include "binned.h"
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

  /// Calls visit(index) for each place within a box (and a few around it).
  template <class Visit>
  void within(const GridExtent& box, Visit&& visit) const
  {
    const int left = column(box.left), right = column(box.right), near = row(box.near), far = row(box.far);
    for (int r = near; r <= far; ++r)
    {
      for (int c = left; c <= right; ++c)
      {
        const auto bin = static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(c);
        for (const std::uint32_t* place = places_.begin(bin); place != places_.end(bin); ++place)
          visit(*place);
      }
    }
  }

private:
  int column(double x) const;
  int row(double y) const;

  const ScanGrid& grid_;
  double left_ = 0.0, near_ = 0.0, size_ = 1.0;  ///< [m]
  int columns_ = 1, rows_ = 1;
  Binned<std::uint32_t> places_;
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
