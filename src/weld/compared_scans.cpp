#include "compared_scans.h"

#include <algorithm>
#include <cmath>

#include "statistics.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kBin = 2.5e-4;       // [m]
constexpr double kMostBins = 2000.0;  // a side
}  // namespace

Vector6d ComparedScans::heightJacobian(const Eigen::Vector3d& place, double slope_x, double slope_y) const
{
  const Eigen::Vector3d rise(-slope_x, -slope_y, 1.0);
  Vector6d jacobian;
  jacobian << rise, (place - aligned.about).cross(rise);
  return jacobian;
}

void shareAreas(const std::vector<Facet>& facets, ComparedScans& scans)
{
  scans.area.assign(scans.grid.z.size(), 0.0F);
  scans.common_area = scans.area;
  for (const Facet& facet : facets)
  {
    const auto share = static_cast<float>(doubledArea(scans.grid, facet) / 6.0);
    const bool common = std::isfinite(scans.after[facet.a].z) && std::isfinite(scans.after[facet.b].z) &&
                        std::isfinite(scans.after[facet.c].z);
    for (const std::uint32_t i : { facet.a, facet.b, facet.c })
    {
      scans.area[i] += share;
      scans.common_area[i] += common ? share : 0.0F;
    }
  }
}

CompareBins::CompareBins(const ComparedScans& scans)
{
  const ScanGrid& grid = scans.grid;
  const GridExtent extent = extentOf(grid, [&scans](std::size_t i) { return scans.known(i); });
  if (extent.empty())
    return;
  left_ = extent.left, near_ = extent.near;
  // bins without a point would cut spots to pieces
  size_ =
      std::max({ kBin, 1.3 * grid.pitch, 3.0 * grid.spacing, extent.width() / kMostBins, extent.length() / kMostBins });
  columns_ = static_cast<int>(extent.width() / size_) + 1;
  rows_ = static_cast<int>(extent.length() / size_) + 1;
  bins_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  for (std::size_t i = 0; i < grid.z.size(); ++i)
  {
    if (!scans.known(i) || !std::isfinite(scans.maps.target[i]))
      continue;
    const std::size_t bin = index(rowOf(static_cast<double>(grid.y[i])), columnOf(static_cast<double>(grid.x[i])));
    add(scans, i, bins_[bin]);
  }
  average(scans);
  lowerTheRest(scans.rest);
}

void CompareBins::average(const ComparedScans& scans)
{
  for (Bin& bin : bins_)
  {
    if (bin.points == 0)
      continue;
    for (double* sum : { &bin.x, &bin.y, &bin.z, &bin.above, &bin.taken, &bin.target, &bin.noise })
      *sum /= bin.area;
    if (bin.metal_area > 0.0)
      bin.metal_above /= bin.metal_area;
    // points of one row err alike
    const double independent = std::max(static_cast<double>(bin.rows), bin.points / scans.noise.alike);
    bin.noise *= square(scans.noise.factor) / independent;
  }
}

void CompareBins::lowerTheRest(double rest)
{
  for (int row = 0; row < rows_; ++row)
  {
    for (int column = 0; column < columns_; ++column)
    {
      Bin& bin = bins_[index(row, column)];
      const double tilt = std::sqrt(1.0 + square(slope(row, column, true)) + square(slope(row, column, false)));
      // elsewhere than on the weld the target leaves nothing
      const double standing = bin.metal_area > 0.0 ? rest * tilt : 0.0;
      bin.not_there = std::clamp(-(bin.above + bin.taken), 0.0, standing);
    }
  }
}

void CompareBins::add(const ComparedScans& scans, std::size_t i, Bin& bin)
{
  const ScanGrid& grid = scans.grid;
  const auto area = static_cast<double>(scans.common_area[i]);
  ++bin.points;
  const int row = static_cast<int>(i / static_cast<std::size_t>(grid.cells));
  bin.rows += row != bin.last_row ? 1 : 0;
  bin.last_row = row;
  bin.spatter = bin.spatter || scans.maps.labels[i] == static_cast<std::uint8_t>(WeldLabel::Spatter);
  bin.area += area;
  bin.x += area * static_cast<double>(grid.x[i]);
  bin.y += area * static_cast<double>(grid.y[i]);
  bin.z += area * static_cast<double>(scans.after[i].z);
  bin.above += area * scans.above(i);
  bin.taken += area * scans.taken(i);
  bin.target += area * static_cast<double>(scans.maps.target[i]);
  bin.noise += area * (static_cast<double>(scans.after[i].variance) + pointVariance(grid, i));
  if (!isMetal(scans.maps.labels[i]))
    return;
  bin.metal_area += area;
  bin.metal_above += area * scans.above(i);
}

/// Of the target.
double CompareBins::slope(int row, int column, bool along_x) const
{
  const auto neighbour = [&](int step) -> const Bin*
  {
    const int r = along_x ? row : row + step, c = along_x ? column + step : column;
    if (r < 0 || c < 0 || r >= rows_ || c >= columns_ || at(r, c).points == 0)
      return nullptr;
    return &at(r, c);
  };
  const Bin* const low = neighbour(-1) != nullptr ? neighbour(-1) : &at(row, column);
  const Bin* const high = neighbour(1) != nullptr ? neighbour(1) : &at(row, column);
  const double run = along_x ? high->x - low->x : high->y - low->y;
  return run > 0.1 * size_ ? (high->target - low->target) / run : 0.0;
}

double CompareBins::variance(const ComparedScans& scans, int row, int column) const
{
  const Bin& bin = at(row, column);
  const Vector6d jacobian =
      scans.heightJacobian({ bin.x, bin.y, bin.z }, slope(row, column, true), slope(row, column, false));
  return bin.noise + jacobian.dot(scans.aligned.covariance * jacobian);
}
}  // namespace weld
}  // namespace weld_profiler
