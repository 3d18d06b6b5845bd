#include "section_sampler.h"

#include <algorithm>
#include <cmath>

#include "statistics.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kBridge = 3.2;    // rows that may lie between two points interpolated between
constexpr double kAlone = 0.6;     // rows that one point alone may be off the plane
constexpr double kOneSided = 2.0;  // of a ripple the slope times this distance, over what it bends over a pitch
}  // namespace

SectionSampler::SectionSampler(const ScanGrid& grid, const WeldPath& path) : grid_(grid), path_(path)
{
  places_.resize(grid.z.size());
  for (int row = 0; row < grid.rows; ++row)
    placeRow(row);
}

/// Holes have a place, too: where the row would go on. The search for a plane walks over them.
void SectionSampler::placeRow(int row)
{
  int first = 0;
  while (first < grid_.cells && !std::isfinite(grid_.z[grid_.at(row, first)]))
    ++first;
  if (first == grid_.cells)
    return;  // rows without points are not in the grid
  const std::size_t begin = grid_.at(row, 0), end = begin + static_cast<std::size_t>(grid_.cells);
  double x = static_cast<double>(grid_.x[begin + static_cast<std::size_t>(first)]) - (first + 1) * grid_.spacing;
  double y = static_cast<double>(grid_.y[begin + static_cast<std::size_t>(first)]);
  double near_s = path_.locate(x, y, path_.sAt(y)).s;
  WeldPath::Together points;
  for (std::size_t i = begin; i < end; i += WeldPath::kTogether)
  {
    const std::size_t count = std::min(WeldPath::kTogether, end - i);
    for (std::size_t j = 0; j < WeldPath::kTogether; ++j)
    {
      const bool hole = j >= count || !std::isfinite(grid_.z[i + j]);
      x = hole ? x + grid_.spacing : static_cast<double>(grid_.x[i + j]);
      y = hole ? y : static_cast<double>(grid_.y[i + j]);
      points.x[j] = x, points.y[j] = y;
    }
    path_.locate(near_s, points);
    for (std::size_t j = 0; j < count; ++j)
      places_[i + j] = SmallPlace{ static_cast<float>(points.q[j]), static_cast<float>(points.s[j]) };
    near_s = points.s.back();  // a guess for the next ones
  }
}

int SectionSampler::nearestRow(double y) const
{
  const std::vector<double>& rows = grid_.row_y;
  const auto after = static_cast<std::size_t>(std::lower_bound(rows.begin(), rows.end(), y) - rows.begin());
  const bool before_is_nearer = after == rows.size() || (after > 0 && y - rows[after - 1] < rows[after] - y);
  return static_cast<int>(after) - (before_is_nearer ? 1 : 0);
}

void SectionSampler::sample(double s, const std::vector<std::uint8_t>& masked, SectionProfile& profile) const
{
  profile.place = path_.at(s);
  int row = nearestRow(profile.place.y);  // where the last column crossed the plane
  profile.scan_row = grid_.scan_row[static_cast<std::size_t>(row)];
  profile.row_pitch = grid_.pitch * std::cos(profile.place.yaw);
  const auto cells = static_cast<std::size_t>(grid_.cells);
  for (std::vector<double>* field : { &profile.q, &profile.z })
  {
    field->clear();
    field->reserve(cells);
  }
  profile.between.clear();
  profile.between.reserve(cells);
  const auto usable = [&](std::size_t i) { return std::isfinite(grid_.z[i]) && (masked.empty() || masked[i] == 0); };
  const double most = kBridge * profile.row_pitch;
  for (int column = 0; column < grid_.cells; ++column)
  {
    std::size_t i = grid_.at(row, column);
    for (; row + 1 < grid_.rows && along(i + cells) <= s; i += cells)
      ++row;
    for (; row > 0 && along(i) > s; i -= cells)
      --row;
    // mostly both are there
    if (row + 1 < grid_.rows && along(i) <= s && usable(i) && usable(i + cells))
    {
      const double before = s - along(i), after = along(i + cells) - s;
      if (before + after <= most)
      {
        put(Mixture{ i, i + cells, before / (before + after), before * after }, profile);
        continue;
      }
    }
    lookAround(Crossing{ s, row, column }, masked, profile);
  }
}

void SectionSampler::lookAround(const Crossing& at, const std::vector<std::uint8_t>& masked,
                                SectionProfile& profile) const
{
  const int reach = 3;
  const auto usable = [&](std::size_t i) { return std::isfinite(grid_.z[i]) && (masked.empty() || masked[i] == 0); };
  int below = -1, above = -1;
  for (int r = std::min(grid_.rows - 1, at.row + 1); r >= std::max(0, at.row - reach) && below < 0; --r)
    if (usable(grid_.at(r, at.column)) && along(grid_.at(r, at.column)) <= at.s)
      below = r;
  for (int r = std::max(0, at.row - 1); r <= std::min(grid_.rows - 1, at.row + 1 + reach) && above < 0; ++r)
    if (usable(grid_.at(r, at.column)) && along(grid_.at(r, at.column)) > at.s)
      above = r;
  add(at.s, at.column, below, above, profile);
}

void SectionSampler::add(double s, int column, int below, int above, SectionProfile& profile) const
{
  const double before = below < 0 ? kNaN : s - place(grid_.at(below, column)).s;
  const double after = above < 0 ? kNaN : place(grid_.at(above, column)).s - s;
  double share = kNaN;  // of the point above
  double between = before * after;
  if (before + after <= kBridge * profile.row_pitch)
    share = before / (before + after);
  else if (before <= kAlone * profile.row_pitch)
    share = 0.0, between = -kOneSided * before * profile.row_pitch;
  else if (after <= kAlone * profile.row_pitch)
    share = 1.0, between = -kOneSided * after * profile.row_pitch;
  else
    return;
  put(Mixture{ grid_.at(share < 1.0 ? below : above, column), grid_.at(share > 0.0 ? above : below, column), share,
               between },
      profile);
}

void SectionSampler::put(const Mixture& of, SectionProfile& profile) const
{
  const double rest = 1.0 - of.share;
  profile.q.push_back(rest * place(of.below).q + of.share * place(of.above).q);
  profile.z.push_back(rest * static_cast<double>(grid_.z[of.below]) +
                      of.share * static_cast<double>(grid_.z[of.above]));
  profile.between.push_back(static_cast<float>(of.between));
}
}  // namespace weld
}  // namespace weld_profiler
