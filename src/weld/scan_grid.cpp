#include "scan_grid.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "statistics.h"
#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
double medianY(const Profile& profile)
{
  std::vector<double> values;
  values.reserve(profile.points.size() / 8 + 1);
  for (std::size_t i = 0; i < profile.points.size(); i += 8)
    values.push_back(profile.points[i].y);
  return median(std::move(values));
}

void fillRow(const Profile& profile, int row, ScanGrid& grid)
{
  for (const CloudPoint& point : profile.points)
  {
    if (point.cell >= grid.cells)
      throw PreconditionError("a point of the scan has cell " + std::to_string(point.cell) + ", but the scan has " +
                              std::to_string(grid.cells) + " columns");
    const bool finite =
        std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z) && std::isfinite(point.sigma);
    if (!finite || (point.flags & stripe_flag::kInterpolated) != 0)
      continue;
    const std::size_t i = grid.at(row, grid.column(point.cell));
    grid.x[i] = point.x, grid.y[i] = point.y, grid.z[i] = point.z;
    grid.sigma[i] = point.sigma;
  }
}

/// Whether x falls with rising cells in most rows.
bool xFalls(const std::vector<const Profile*>& profiles)
{
  int votes = 0;
  for (const Profile* profile : profiles)
  {
    if (profile->points.size() < 2)
      continue;
    votes += profile->points.back().x < profile->points.front().x ? 1 : -1;
  }
  return votes > 0;
}

/// Median step in x from cell to cell, from a few rows.
double medianSpacing(const ScanGrid& grid)
{
  std::vector<double> steps;
  const int stride = std::max(1, grid.rows / 16);
  for (int row = 0; row < grid.rows; row += stride)
  {
    for (int cell = 1; cell < grid.cells; ++cell)
    {
      const std::size_t i = grid.at(row, cell);
      if (std::isfinite(grid.z[i]) && std::isfinite(grid.z[i - 1]))
        steps.push_back(std::abs(grid.x[i] - grid.x[i - 1]));
    }
  }
  return median(std::move(steps));
}

ScanGrid build(const std::vector<const Profile*>& profiles, std::uint32_t cells)
{
  ScanGrid grid;
  grid.cells = static_cast<int>(cells);
  grid.mirrored = xFalls(profiles);
  std::vector<double> places(profiles.size());
  for (std::size_t i = 0; i < profiles.size(); ++i)
  {
    places[i] = medianY(*profiles[i]);
    if (std::isfinite(places[i]))
      grid.scan_row.push_back(static_cast<int>(i));
  }
  const auto place = [&places](int row) { return places[static_cast<std::size_t>(row)]; };
  std::stable_sort(grid.scan_row.begin(), grid.scan_row.end(), [&](int a, int b) { return place(a) < place(b); });
  grid.rows = static_cast<int>(grid.scan_row.size());
  const std::size_t count = static_cast<std::size_t>(grid.rows) * cells;
  for (std::vector<float>* field : { &grid.x, &grid.y, &grid.z, &grid.sigma })
    field->assign(count, std::numeric_limits<float>::quiet_NaN());
  std::vector<double> steps;
  for (int row = 0; row < grid.rows; ++row)
  {
    const int from = grid.scan_row[static_cast<std::size_t>(row)];
    grid.row_y.push_back(place(from));
    if (row > 0)
      steps.push_back(grid.row_y.back() - grid.row_y[static_cast<std::size_t>(row) - 1]);
    fillRow(*profiles[static_cast<std::size_t>(from)], row, grid);
  }
  grid.pitch = median(std::move(steps));
  grid.spacing = medianSpacing(grid);
  return grid;
}
}  // namespace

ScanGrid makeGrid(const Scan& scan)
{
  std::vector<const Profile*> profiles;
  profiles.reserve(scan.rows.size());
  for (const Profile& row : scan.rows)
    profiles.push_back(&row);
  return build(profiles, scan.cells);
}

ScanGrid makeGrid(const Profile& profile)
{
  return build({ &profile }, profile.cells);
}
}  // namespace weld
}  // namespace weld_profiler
