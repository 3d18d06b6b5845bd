#include "moved_surface.h"

#include <algorithm>
#include <cmath>

#include "statistics.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kMostBins = 4e6;
constexpr double kLeastSigma = 1e-7;  // a point is never exact [m]
constexpr double kEdge = -1e-6;       // share by which a place may lie outside of a facet: neighbours leave no seam

struct Corner
{
  Eigen::Vector3d place;
  double variance = 0.0;
};

class Sampler
{
public:
  Sampler(const PlaceBins& bins, std::vector<SurfaceSample>& samples)
    : bins_(bins), places_(bins.grid()), samples_(samples)
  {
  }

  void operator()(const Corner (&corners)[3])
  {
    const Eigen::Vector3d &a = corners[0].place, &b = corners[1].place, &c = corners[2].place;
    const Eigen::Vector3d normal = (b - a).cross(c - a);
    if (!(normal.z() > 0.0))
      return;
    const auto x = std::minmax({ a.x(), b.x(), c.x() }), y = std::minmax({ a.y(), b.y(), c.y() });
    const float slope_x = static_cast<float>(-normal.x() / normal.z());
    const float slope_y = static_cast<float>(-normal.y() / normal.z());
    bins_.within({ x.first, x.second, y.first, y.second },
                 [&](std::uint32_t i)
                 {
                   const double px = static_cast<double>(places_.x[i]) - a.x();
                   const double py = static_cast<double>(places_.y[i]) - a.y();
                   const double wb = (px * (c.y() - a.y()) - py * (c.x() - a.x())) / normal.z();
                   const double wc = (py * (b.x() - a.x()) - px * (b.y() - a.y())) / normal.z();
                   const double wa = 1.0 - wb - wc;
                   if (wa < kEdge || wb < kEdge || wc < kEdge)
                     return;
                   const auto z = static_cast<float>(wa * a.z() + wb * b.z() + wc * c.z());
                   if (z <= samples_[i].z)
                     return;
                   const double variance = square(wa) * corners[0].variance + square(wb) * corners[1].variance +
                                           square(wc) * corners[2].variance;
                   samples_[i] = { z, static_cast<float>(variance), slope_x, slope_y };
                 });
  }

private:
  const PlaceBins& bins_;
  const ScanGrid& places_;
  std::vector<SurfaceSample>& samples_;
};
}  // namespace

double pointVariance(const ScanGrid& grid, std::size_t i)
{
  return square(std::max(kLeastSigma, static_cast<double>(grid.sigma[i])));
}

PlaceBins::PlaceBins(const ScanGrid& grid, const std::vector<std::uint8_t>& wanted) : grid_(grid)
{
  const auto use = [&](std::size_t i) { return std::isfinite(grid.z[i]) && (wanted.empty() || wanted[i] != 0); };
  GridExtent extent = extentOf(grid, use);
  if (extent.empty())
    extent = { 0.0, 0.0, 0.0, 0.0 };
  left_ = extent.left, near_ = extent.near;
  size_ = std::max(
      { 2e-4, std::sqrt(extent.width() * extent.length() / kMostBins), extent.width() / 1e4, extent.length() / 1e4 });
  columns_ = static_cast<int>(extent.width() / size_) + 1;
  rows_ = static_cast<int>(extent.length() / size_) + 1;
  const auto binOf = [&](std::size_t i)
  {
    return static_cast<std::size_t>(row(static_cast<double>(grid.y[i]))) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column(static_cast<double>(grid.x[i])));
  };
  places_.fill(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_),
               [&](const auto& put)
               {
                 for (std::size_t i = 0; i < grid.z.size(); ++i)
                   if (use(i))
                     put(binOf(i), static_cast<std::uint32_t>(i));
               });
}

int PlaceBins::column(double x) const
{
  return static_cast<int>(std::clamp((x - left_) / size_, 0.0, static_cast<double>(columns_ - 1)));
}

int PlaceBins::row(double y) const
{
  return static_cast<int>(std::clamp((y - near_) / size_, 0.0, static_cast<double>(rows_ - 1)));
}

void sampleSurface(const SurfaceView& surface, const Eigen::Isometry3d& motion, const PlaceBins& places,
                   std::vector<SurfaceSample>& samples)
{
  samples.assign(places.grid().z.size(), SurfaceSample());
  const ScanGrid& grid = surface.grid;
  Sampler sampler(places, samples);
  std::vector<Corner> moved(grid.z.size());
  for (std::size_t i = 0; i < grid.z.size(); ++i)
  {
    if (std::isfinite(grid.z[i]))
      moved[i] = { motion * Eigen::Vector3d(static_cast<double>(grid.x[i]), static_cast<double>(grid.y[i]),
                                            static_cast<double>(grid.z[i])),
                   pointVariance(grid, i) };
  }
  for (const Facet& facet : surface.facets)
  {
    const Corner corners[3] = { moved[facet.a], moved[facet.b], moved[facet.c] };
    sampler(corners);
  }
}
}  // namespace weld
}  // namespace weld_profiler
