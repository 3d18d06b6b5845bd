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

void SectionSampler::sample(double s, const std::vector<std::uint8_t>& masked, SectionProfile& profile) const
{
  profile.place = path_.at(s);
  const auto nearest = std::lower_bound(grid_.row_y.begin(), grid_.row_y.end(), profile.place.y);
  int middle = static_cast<int>(nearest - grid_.row_y.begin());
  if (middle == grid_.rows || (middle > 0 && profile.place.y - grid_.row_y[static_cast<std::size_t>(middle) - 1] <
                                                 grid_.row_y[static_cast<std::size_t>(middle)] - profile.place.y))
    --middle;
  profile.scan_row = grid_.scan_row[static_cast<std::size_t>(middle)];
  profile.row_pitch = grid_.pitch * std::cos(profile.place.yaw);
  for (std::vector<double>* field : { &profile.q, &profile.z })
  {
    field->clear();
    field->reserve(static_cast<std::size_t>(grid_.cells));
  }
  profile.between.clear();
  profile.between.reserve(static_cast<std::size_t>(grid_.cells));
  const auto usable = [&](std::size_t i) { return std::isfinite(grid_.z[i]) && (masked.empty() || masked[i] == 0); };
  const int reach = 3;
  const auto cells = static_cast<std::size_t>(grid_.cells);
  const double most = kBridge * profile.row_pitch;
  int row = middle;  // where the last column crossed the plane
  for (int column = 0; column < grid_.cells; ++column)
  {
    const auto along = [&](int r) { return static_cast<double>(places_[grid_.at(r, column)].s); };
    std::size_t i = grid_.at(row, column);
    for (; row + 1 < grid_.rows && static_cast<double>(places_[i + cells].s) <= s; i += cells)
      ++row;
    for (; row > 0 && static_cast<double>(places_[i].s) > s; i -= cells)
      --row;
    // mostly both are there
    if (row + 1 < grid_.rows && static_cast<double>(places_[i].s) <= s && usable(i) && usable(i + cells))
    {
      const double before = s - place(i).s, after = place(i + cells).s - s;
      if (before + after <= most)
      {
        put(Mixture{ i, i + cells, before / (before + after), before * after }, profile);
        continue;
      }
    }
    int below = -1, above = -1;
    for (int r = std::min(grid_.rows - 1, row + 1); r >= std::max(0, row - reach) && below < 0; --r)
      if (usable(grid_.at(r, column)) && along(r) <= s)
        below = r;
    for (int r = std::max(0, row - 1); r <= std::min(grid_.rows - 1, row + 1 + reach) && above < 0; ++r)
      if (usable(grid_.at(r, column)) && along(r) > s)
        above = r;
    add(s, column, below, above, profile);
  }
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
