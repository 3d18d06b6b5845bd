#include <algorithm>
#include <cmath>

#include "undercut_match.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kSearchStep = 2e-4;  // walls are longer [m]
constexpr double kAlike = 0.4;        // of a patch's depth: half a step off
constexpr int kMostSteps = 10;        // to either side

/// Facets that come to lie within an extent, or nearer to it than a reach.
std::vector<Facet> facetsWithin(const SurfaceView& surface, const Eigen::Isometry3d& motion, const GridExtent& extent,
                                double reach)
{
  std::vector<Facet> within;
  for (const Facet& facet : surface.facets)
  {
    const double x = (motion * Eigen::Vector3d(static_cast<double>(surface.grid.x[facet.a]),
                                               static_cast<double>(surface.grid.y[facet.a]),
                                               static_cast<double>(surface.grid.z[facet.a])))
                         .x();
    if (x > extent.left - reach && x < extent.right + reach)
      within.push_back(facet);
  }
  return within;
}
}  // namespace

Eigen::Isometry3d UndercutMatch::search(const SurfaceView& after, const Eigen::Isometry3d& motion,
                                        const Eigen::Vector3d& across, double reach) const
{
  std::vector<std::uint8_t> mask(grid_.z.size(), 0);
  want(mask);
  const PlaceBins bins(grid_, mask);
  const std::vector<Facet> near =
      facetsWithin(after, motion, extentOf(grid_, [&mask](std::size_t i) { return mask[i] != 0; }), reach);
  const SurfaceView surface{ after.grid, near };
  std::vector<SurfaceSample> samples;
  double place = 0.0, least = INFINITY;
  const auto attempt = [&](double shift)
  {
    sampleSurface(surface, Eigen::Translation3d(shift * across) * motion, bins, samples);
    const double misfit = this->misfit(samples, kAlike);
    if (misfit < least)
      least = misfit, place = shift;
  };
  const int steps = std::min(kMostSteps, static_cast<int>(std::ceil(reach / kSearchStep)));
  attempt(0.0);
  for (int i = 1; i <= steps; ++i)
    for (const double side : { -1.0, 1.0 })
      attempt(side * i * kSearchStep);
  const double coarse = place;
  for (const double side : { -0.5, 0.5 })
    attempt(coarse + side * kSearchStep);
  return Eigen::Translation3d(place * across) * motion;
}
}  // namespace weld
}  // namespace weld_profiler
