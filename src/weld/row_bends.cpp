#include "row_bends.h"

#include <algorithm>
#include <cmath>

#include "statistics.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kCrest = 3.5e-4;        // half of the strip along the crest that tells it [m]
constexpr double kStretch = 5e-3;        // of weld to either side, several ripples [m]
constexpr double kNeighbouring = 1.6;    // row pitches between rows that are neighbours
constexpr int kFewestColumns = 3;        // of the strip
constexpr std::size_t kFewestRows = 10;  // of a stretch
constexpr double kRipple = 2.0;          // medians that ripples bend by at most

struct RowBend
{
  double s = 0.0, bend = 0.0;
};

/// Tells the bend at one row after the other.
class BendOfRows
{
public:
  BendOfRows(const SectionSampler& sampler, const std::vector<std::uint8_t>& masked)
    : sampler_(sampler), grid_(sampler.grid()), masked_(masked)
  {
  }

  /// s where a row crosses the path.
  double placeOf(int row) const { return sampler_.place(grid_.at(row, columnAt(row, 0.0))).s; }

  /// Mean over the strip about q, of a row and those before and behind it; NaN where too little of them is seen.
  double operator()(int row, double q) const
  {
    double sum = 0.0;
    int count = 0;
    const int end = columnAt(row, q + kCrest);
    for (int column = columnAt(row, q - kCrest); column < end; ++column)
    {
      const double bend = bendAt(row, column);
      if (!std::isfinite(bend))
        continue;
      sum += bend;
      ++count;
    }
    return count < kFewestColumns ? kNaN : sum / count;
  }

  /// Whether the rows before and behind are the next ones that were scanned.
  bool amongNeighbours(int row) const
  {
    const auto r = static_cast<std::size_t>(row);
    return std::max(grid_.row_y[r] - grid_.row_y[r - 1], grid_.row_y[r + 1] - grid_.row_y[r]) <
           kNeighbouring * grid_.pitch;
  }

private:
  /// First column of a row that lies at q or beyond it, or the last.
  int columnAt(int row, double q) const
  {
    int from = 0, to = grid_.cells - 1;
    while (from < to)
    {
      const int middle = (from + to) / 2;
      if (sampler_.place(grid_.at(row, middle)).q < q)
        from = middle + 1;
      else
        to = middle;
    }
    return from;
  }

  /// Second divided difference of the heights; NaN where one of the three is missing.
  double bendAt(int row, int column) const
  {
    double s[3], z[3];
    for (int i = 0; i < 3; ++i)
    {
      const std::size_t point = grid_.at(row - 1 + i, column);
      s[i] = sampler_.place(point).s;
      z[i] = masked_.empty() || masked_[point] == 0 ? static_cast<double>(grid_.z[point]) : kNaN;
    }
    return ((z[2] - z[1]) / (s[2] - s[1]) - (z[1] - z[0]) / (s[1] - s[0])) / (s[2] - s[0]);
  }

  const SectionSampler& sampler_;
  const ScanGrid& grid_;
  const std::vector<std::uint8_t>& masked_;
};

/// Quadratic mean over what lies within a distance of s; NaN of too few. Where a bead begins or ends it bends by more
/// than ripples do: the largest bend of a sine is sqrt(2) its median.
double meanAbout(const std::vector<RowBend>& bends, double s, double distance)
{
  std::vector<double> near;
  for (const RowBend& one : bends)
  {
    if (std::abs(one.s - s) <= distance)
      near.push_back(std::abs(one.bend));
  }
  if (near.size() < std::min(kFewestRows, bends.size()))
    return kNaN;
  const double most = kRipple * median(near);
  double squares = 0.0;
  for (const double bend : near)
    squares += square(std::min(bend, most));
  return std::sqrt(squares / static_cast<double>(near.size()));
}
}  // namespace

std::vector<double> rowBends(const SectionSampler& sampler, const std::vector<std::uint8_t>& masked,
                             const std::vector<double>& places, const std::vector<double>& crests)
{
  const BendOfRows bend_of(sampler, masked);
  std::vector<RowBend> neighbours, all;
  for (int row = 1; row + 1 < sampler.grid().rows; ++row)
  {
    const double s = bend_of.placeOf(row);
    const auto after = std::lower_bound(places.begin(), places.end(), s);
    const auto k = std::min(static_cast<std::size_t>(after - places.begin()), places.size() - 1);
    const double bend = std::isfinite(crests[k]) ? bend_of(row, crests[k]) : kNaN;
    if (!std::isfinite(bend))
      continue;
    all.push_back(RowBend{ s, bend });
    if (bend_of.amongNeighbours(row))
      neighbours.push_back(all.back());
  }
  // rows farther apart than ripples are long tell less of them
  const std::vector<RowBend>& bends = neighbours.size() < kFewestRows ? all : neighbours;
  std::vector<double> result(places.size(), 0.0);
  if (bends.empty())
    return result;
  for (std::size_t k = 0; k < places.size(); ++k)
  {
    const double near = meanAbout(bends, places[k], kStretch);
    result[k] = std::isfinite(near) ? near : meanAbout(bends, places[k], INFINITY);
  }
  return result;
}
}  // namespace weld
}  // namespace weld_profiler
