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
  return isMetal(label) || label == static_cast<std::uint8_t>(WeldLabel::Undercut);
}
}  // namespace

bool isMetal(std::uint8_t label)
{
  return label == static_cast<std::uint8_t>(WeldLabel::Bead) || label == static_cast<std::uint8_t>(WeldLabel::Spatter);
}

GridMaps gridMaps(const ScanGrid& grid, const WeldResult& result)
{
  GridMaps maps;
  maps.labels.assign(grid.z.size(), 0);
  maps.target.assign(grid.z.size(), std::numeric_limits<float>::quiet_NaN());
  for (int row = 0; row < grid.rows; ++row)
  {
    for (int column = 0; column < grid.cells; ++column)
    {
      const std::size_t in_grid = grid.at(row, column);
      if (!std::isfinite(grid.z[in_grid]))
        continue;
      const std::size_t in_scan = grid.inScan(row, column);
      maps.labels[in_grid] = result.labels[in_scan];
      maps.target[in_grid] = result.target[in_scan];
    }
  }
  return maps;
}

std::vector<float> distanceToWeld(const ScanGrid& grid, const std::vector<std::uint8_t>& labels)
{
  const GridExtent extent = extentOf(grid, [&grid](std::size_t i) { return std::isfinite(grid.z[i]); });
  std::vector<float> distances(grid.z.size(), std::numeric_limits<float>::infinity());
  if (extent.empty())
    return distances;
  const double bin = std::max({ kBin, extent.width() / kMostBins, extent.length() / kMostBins });
  const auto column = [&](std::size_t i)
  { return static_cast<int>((static_cast<double>(grid.x[i]) - extent.left) / bin); };
  const auto row = [&](std::size_t i)
  { return static_cast<int>((static_cast<double>(grid.y[i]) - extent.near) / bin); };
  cv::Mat1b elsewhere(static_cast<int>(extent.length() / bin) + 1, static_cast<int>(extent.width() / bin) + 1,
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
