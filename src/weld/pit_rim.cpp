#include "pit_rim.h"

#include <algorithm>
#include <cmath>

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr int kBeside = 2;      // cells: two thirds of the points may be missing, and one of 15 is still there
constexpr double kWide = 3e-4;  // the rim: what the pit blurs (0.13 mm) and about as much again [m]

/// A window of the grid about a pit, that may reach beyond the scan.
struct Window
{
  Window(const ScanGrid& grid, const std::vector<std::size_t>& pit)
    : rows(grid.pitch > 0.0 ? std::max(1, static_cast<int>(std::lround(kWide / grid.pitch))) : 0),
      columns(std::max(1, static_cast<int>(std::lround(kWide / grid.spacing)))),
      cells(static_cast<std::size_t>(grid.cells)),
      from_row(grid.rows),
      from_column(grid.cells)
  {
    for (const std::size_t i : pit)
    {
      from_row = std::min(from_row, rowOf(i)), to_row = std::max(to_row, rowOf(i));
      from_column = std::min(from_column, columnOf(i)), to_column = std::max(to_column, columnOf(i));
    }
    from_row -= rows, to_row += rows;
    from_column -= columns, to_column += columns;
  }

  int rowOf(std::size_t i) const { return static_cast<int>(i / cells); }
  int columnOf(std::size_t i) const { return static_cast<int>(i % cells); }
  int width() const { return to_column + 1 - from_column; }
  int at(int row, int column) const { return (row - from_row) * width() + column - from_column; }

  int rows, columns;  ///< half widths of the rim
  std::size_t cells;
  int from_row, to_row = 0, from_column, to_column = 0;
};

/// Of each cell of the window, whether it belongs to the rim.
std::vector<std::uint8_t> rimOf(const Window& window, const std::vector<std::size_t>& pit)
{
  std::vector<std::uint8_t> rim(static_cast<std::size_t>(window.at(window.to_row, window.to_column)) + 1, 0);
  for (const std::size_t i : pit)
  {
    const int column = window.columnOf(i) - window.columns;
    for (int row = window.rowOf(i) - window.rows; row <= window.rowOf(i) + window.rows; ++row)
      std::fill_n(rim.begin() + window.at(row, column), 2 * window.columns + 1, static_cast<std::uint8_t>(1));
  }
  for (const std::size_t i : pit)
    rim[static_cast<std::size_t>(window.at(window.rowOf(i), window.columnOf(i)))] = 0;
  return rim;
}
/// Whether a place shows the face: where its point is missing by itself, those beside it tell.
bool showsFace(const ScanGrid& grid, int row, int column, const std::vector<std::uint8_t>& face)
{
  if (row < 0 || row >= grid.rows || column < 0 || column >= grid.cells)
    return false;
  if (std::isfinite(grid.z[grid.at(row, column)]))
    return face[grid.at(row, column)] != 0;
  for (int r = std::max(0, row - 1); r <= std::min(grid.rows - 1, row + 1); ++r)
  {
    for (int c = std::max(0, column - kBeside); c <= std::min(grid.cells - 1, column + kBeside); ++c)
    {
      if (face[grid.at(r, c)] != 0)
        return true;
    }
  }
  return false;
}

/// Of places that follow one another from a point on, those up to the next that was measured.
std::size_t missingBeside(const ScanGrid& grid, std::size_t point, int step)
{
  const int row = static_cast<int>(point / static_cast<std::size_t>(grid.cells));
  const int from = static_cast<int>(point % static_cast<std::size_t>(grid.cells)) + step;
  int column = from;
  while (column >= 0 && column < grid.cells && !std::isfinite(grid.z[grid.at(row, column)]))
    column += step;
  return static_cast<std::size_t>(std::abs(column - from));
}
}  // namespace

std::size_t hiddenBeside(const ScanGrid& grid, const std::vector<std::size_t>& pit)
{
  std::size_t hidden = 0;
  for (const std::size_t i : pit)
  {
    for (const int step : { -1, 1 })
    {
      const std::size_t missing = missingBeside(grid, i, step);
      hidden += static_cast<double>(missing) * grid.spacing > kWide ? missing : 0;
    }
  }
  return hidden;
}

double faceAround(const ScanGrid& grid, const std::vector<std::size_t>& pit, const std::vector<std::uint8_t>& face)
{
  const Window window(grid, pit);
  const std::vector<std::uint8_t> rim = rimOf(window, pit);
  std::size_t all = 0, shown = 0;
  for (int row = window.from_row; row <= window.to_row; ++row)
  {
    for (int column = window.from_column; column <= window.to_column; ++column)
    {
      if (rim[static_cast<std::size_t>(window.at(row, column))] == 0)
        continue;
      ++all;
      shown += showsFace(grid, row, column, face) ? 1 : 0;
    }
  }
  return all > 0 ? static_cast<double>(shown) / static_cast<double>(all) : 0.0;
}

void maskAround(const ScanGrid& grid, std::size_t point, double reach, std::vector<std::uint8_t>& masked)
{
  const int row = static_cast<int>(point / static_cast<std::size_t>(grid.cells));
  const int column = static_cast<int>(point % static_cast<std::size_t>(grid.cells));
  const int columns = static_cast<int>(std::ceil(reach / grid.spacing));
  const int rows = grid.pitch > 0.0 ? static_cast<int>(std::lround(reach / grid.pitch)) : 0;
  for (int r = std::max(0, row - rows); r <= std::min(grid.rows - 1, row + rows); ++r)
    for (int c = std::max(0, column - columns); c <= std::min(grid.cells - 1, column + columns); ++c)
      masked[grid.at(r, c)] = 1;
}
}  // namespace weld
}  // namespace weld_profiler
