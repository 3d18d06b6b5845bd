#include "scan_facets.h"

#include <algorithm>
#include <cmath>

#include "statistics.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kUneven = 1.6;  // rows this many times their usual distance apart are still neighbours

class FacetMaker
{
public:
  FacetMaker(const ScanGrid& grid, double max_gap)
    : grid_(grid), within_(square(max_gap)), rows_apart_(std::max(max_gap, kUneven * grid.pitch))
  {
    between_ = within_ + square(rows_apart_);
  }

  std::vector<Facet> operator()()
  {
    std::vector<std::uint32_t> low, high;
    for (int row = 0; row < grid_.rows; ++row)
    {
      low.swap(high);
      pointsOf(row, high);
      const auto i = static_cast<std::size_t>(row);
      if (row > 0 && grid_.row_y[i] - grid_.row_y[i - 1] <= rows_apart_)
        join(low, high);
    }
    return std::move(facets_);
  }

private:
  void pointsOf(int row, std::vector<std::uint32_t>& points) const
  {
    points.clear();
    for (int column = 0; column < grid_.cells; ++column)
    {
      const std::size_t i = grid_.at(row, column);
      if (std::isfinite(grid_.z[i]))
        points.push_back(static_cast<std::uint32_t>(i));
    }
  }

  /// A strip between two rows: whichever row's next point comes first makes the next triangle.
  void join(const std::vector<std::uint32_t>& low, const std::vector<std::uint32_t>& high)
  {
    std::size_t i = 0, j = 0;
    while (i + 1 < low.size() || j + 1 < high.size())
    {
      if (low.empty() || high.empty())
        return;
      const bool more_low = i + 1 < low.size(), more_high = j + 1 < high.size();
      if (more_low && (!more_high || grid_.x[low[i + 1]] <= grid_.x[high[j + 1]]))
      {
        add({ low[i], low[i + 1], high[j] });
        ++i;
      }
      else
      {
        add({ low[i], high[j + 1], high[j] });
        ++j;
      }
    }
  }

  double distance2(std::uint32_t a, std::uint32_t b) const
  {
    return square(static_cast<double>(grid_.x[a]) - static_cast<double>(grid_.x[b])) +
           square(static_cast<double>(grid_.y[a]) - static_cast<double>(grid_.y[b])) +
           square(static_cast<double>(grid_.z[a]) - static_cast<double>(grid_.z[b]));
  }

  bool joined(std::uint32_t a, std::uint32_t b) const
  {
    const auto cells = static_cast<std::uint32_t>(grid_.cells);
    return distance2(a, b) <= (a / cells == b / cells ? within_ : between_);
  }

  void add(const Facet& facet)
  {
    if (joined(facet.a, facet.b) && joined(facet.b, facet.c) && joined(facet.c, facet.a) &&
        doubledArea(grid_, facet) > 0.0)
      facets_.push_back(facet);
  }

  const ScanGrid& grid_;
  double within_ = 0.0, rows_apart_ = 0.0, between_ = 0.0;  // squared, plain, squared
  std::vector<Facet> facets_;
};
}  // namespace

double doubledArea(const ScanGrid& grid, const Facet& facet)
{
  const auto x = [&grid](std::uint32_t i) { return static_cast<double>(grid.x[i]); };
  const auto y = [&grid](std::uint32_t i) { return static_cast<double>(grid.y[i]); };
  return (x(facet.b) - x(facet.a)) * (y(facet.c) - y(facet.a)) - (x(facet.c) - x(facet.a)) * (y(facet.b) - y(facet.a));
}

std::vector<Facet> makeFacets(const ScanGrid& grid, double max_gap)
{
  if (grid.rows < 2)
    return {};
  return FacetMaker(grid, max_gap)();
}
}  // namespace weld
}  // namespace weld_profiler
