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
constexpr double kStandstill = 0.1;  // of the usual step: a row nearer to the one before shows the same place again

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

/// The step that half of the way is gone in steps no longer than: rows at a standstill do not count.
double usualStep(std::vector<double> steps)
{
  std::sort(steps.begin(), steps.end());
  const double half = 0.5 * std::accumulate(steps.begin(), steps.end(), 0.0);
  double gone = 0.0;
  for (const double step : steps)
  {
    gone += step;
    if (gone >= half)
      return step;
  }
  return 0.0;
}

/// Fills in which rows there are, of places along the scan; NaN = a row without points.
void chooseRows(const std::vector<double>& places, ScanGrid& grid)
{
  std::vector<int> order;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    if (std::isfinite(places[i]))
      order.push_back(static_cast<int>(i));
  }
  const auto place = [&places](int row) { return places[static_cast<std::size_t>(row)]; };
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return place(a) < place(b); });
  std::vector<double> steps;
  for (std::size_t i = 1; i < order.size(); ++i)
    steps.push_back(place(order[i]) - place(order[i - 1]));
  const double least = kStandstill * usualStep(std::move(steps));
  grid.row_of.assign(places.size(), -1);
  for (const int row : order)
  {
    if (grid.row_y.empty() || place(row) - grid.row_y.back() > least || least == 0.0)
    {
      grid.scan_row.push_back(row);
      grid.row_y.push_back(place(row));
    }
    grid.row_of[static_cast<std::size_t>(row)] = static_cast<int>(grid.scan_row.size()) - 1;
  }
}

ScanGrid build(const std::vector<const Profile*>& profiles, std::uint32_t cells)
{
  ScanGrid grid;
  grid.cells = static_cast<int>(cells);
  grid.mirrored = xFalls(profiles);
  std::vector<double> places;
  places.reserve(profiles.size());
  for (const Profile* profile : profiles)
    places.push_back(medianY(*profile));
  chooseRows(places, grid);
  grid.rows = static_cast<int>(grid.scan_row.size());
  const std::size_t count = static_cast<std::size_t>(grid.rows) * cells;
  for (std::vector<float>* field : { &grid.x, &grid.y, &grid.z, &grid.sigma })
    field->assign(count, std::numeric_limits<float>::quiet_NaN());
  std::vector<double> steps;
  for (int row = 0; row < grid.rows; ++row)
  {
    const auto at = static_cast<std::size_t>(row);
    if (row > 0)
      steps.push_back(grid.row_y[at] - grid.row_y[at - 1]);
    fillRow(*profiles[static_cast<std::size_t>(grid.scan_row[at])], row, grid);
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
