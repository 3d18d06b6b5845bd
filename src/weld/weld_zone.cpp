#include "weld_zone.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kBin = 1e-4;         // [m]
constexpr double kMostBins = 2000.0;  // a side

bool ofWeld(std::uint8_t label)
{
  return label == static_cast<std::uint8_t>(WeldLabel::Bead) ||
         label == static_cast<std::uint8_t>(WeldLabel::Undercut) ||
         label == static_cast<std::uint8_t>(WeldLabel::Spatter);
}
}  // namespace

GridMaps gridMaps(const ScanGrid& grid, const WeldResult& result)
{
  GridMaps maps;
  maps.labels.assign(grid.z.size(), 0);
  maps.target.assign(grid.z.size(), std::numeric_limits<float>::quiet_NaN());
  for (int row = 0; row < grid.rows; ++row)
  {
    const auto from = static_cast<std::size_t>(grid.scan_row[static_cast<std::size_t>(row)]) * result.cells;
    for (int column = 0; column < grid.cells; ++column)
    {
      const std::size_t in_grid = grid.at(row, column);
      if (!std::isfinite(grid.z[in_grid]))
        continue;
      const std::size_t in_scan = from + static_cast<std::size_t>(grid.column(column));
      maps.labels[in_grid] = result.labels[in_scan];
      maps.target[in_grid] = result.target[in_scan];
    }
  }
  return maps;
}

std::vector<float> distanceToWeld(const ScanGrid& grid, const std::vector<std::uint8_t>& labels)
{
  double left = INFINITY, right = -INFINITY, near = INFINITY, far = -INFINITY;
  for (std::size_t i = 0; i < grid.z.size(); ++i)
  {
    if (!std::isfinite(grid.z[i]))
      continue;
    left = std::min(left, static_cast<double>(grid.x[i])), right = std::max(right, static_cast<double>(grid.x[i]));
    near = std::min(near, static_cast<double>(grid.y[i])), far = std::max(far, static_cast<double>(grid.y[i]));
  }
  std::vector<float> distances(grid.z.size(), std::numeric_limits<float>::infinity());
  if (!(right >= left))
    return distances;
  const double bin = std::max({ kBin, (right - left) / kMostBins, (far - near) / kMostBins });
  const auto column = [&](std::size_t i) { return static_cast<int>((static_cast<double>(grid.x[i]) - left) / bin); };
  const auto row = [&](std::size_t i) { return static_cast<int>((static_cast<double>(grid.y[i]) - near) / bin); };
  cv::Mat1b elsewhere(static_cast<int>((far - near) / bin) + 1, static_cast<int>((right - left) / bin) + 1,
                      std::uint8_t{ 255 });
  bool any = false;
  for (std::size_t i = 0; i < grid.z.size(); ++i)
  {
    if (!std::isfinite(grid.z[i]) || !ofWeld(labels[i]))
      continue;
    elsewhere(row(i), column(i)) = 0;
    any = true;
  }
  if (!any)
    return distances;
  cv::Mat1f bins;
  cv::distanceTransform(elsewhere, bins, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  for (std::size_t i = 0; i < grid.z.size(); ++i)
    if (std::isfinite(grid.z[i]))
      distances[i] = bins(row(i), column(i)) * static_cast<float>(bin);
  return distances;
}
}  // namespace weld
}  // namespace weld_profiler
