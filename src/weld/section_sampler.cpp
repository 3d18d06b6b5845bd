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

SectionSampler::Points::Points(std::size_t most, SectionProfile& profile)
{
  profile.q.resize(most);
  profile.z.resize(most);
  profile.between.resize(most);
  q_ = profile.q.data(), z_ = profile.z.data(), between_ = profile.between.data();
}

void SectionSampler::Points::end(SectionProfile& profile) const
{
  profile.q.resize(count_);
  profile.z.resize(count_);
  profile.between.resize(count_);
}

void SectionSampler::sample(double s, const std::vector<std::uint8_t>& masked, SectionProfile& profile) const
{
  profile.place = path_.at(s);
  int row = nearestRow(profile.place.y);  // where the last column crossed the plane
  profile.row = row;
  profile.scan_row = grid_.scan_row[static_cast<std::size_t>(row)];
  profile.row_pitch = grid_.pitch * std::cos(profile.place.yaw);
  const auto cells = static_cast<std::size_t>(grid_.cells);
  Points points(cells, profile);
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
        put(Mixture{ i, i + cells, before / (before + after), before * after }, points);
        continue;
      }
    }
    Mixture mixture;
    if (lookAround(Crossing{ s, profile.row_pitch, row, column }, masked, mixture))
      put(mixture, points);
  }
  points.end(profile);
}

bool SectionSampler::lookAround(const Crossing& at, const std::vector<std::uint8_t>& masked, Mixture& of) const
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
  const double before = below < 0 ? kNaN : at.s - along(grid_.at(below, at.column));
  const double after = above < 0 ? kNaN : along(grid_.at(above, at.column)) - at.s;
  of.between = before * after;
  if (before + after <= kBridge * at.pitch)
    of.share = before / (before + after);
  else if (before <= kAlone * at.pitch)
    of.share = 0.0, of.between = -kOneSided * before * at.pitch;
  else if (after <= kAlone * at.pitch)
    of.share = 1.0, of.between = -kOneSided * after * at.pitch;
  else
    return false;
  of.below = grid_.at(of.share < 1.0 ? below : above, at.column);
  of.above = grid_.at(of.share > 0.0 ? above : below, at.column);
  return true;
}
}  // namespace weld
}  // namespace weld_profiler
