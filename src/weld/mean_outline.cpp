#include "mean_outline.h"

#include <algorithm>
#include <cmath>

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kCell = 4e-5;     // that heights are averaged in [m]
constexpr double kOutside = 3e-3;  // of the toe that the outline is averaged for [m]
}  // namespace

MeanOutline::MeanOutline(const ToeQuestion& question)
{
  const double middle = 0.5 * (question.guess + question.opposite);
  const double outside = question.guess + sign(question.side) * kOutside;
  from_ = std::min(middle, outside), to_ = std::max(middle, outside);
  cells_.resize(static_cast<std::size_t>(std::ceil((to_ - from_) / kCell)) + 1);
}

void MeanOutline::add(const SectionProfile& profile, const Line& parent, double weight)
{
  auto i = static_cast<std::size_t>(std::lower_bound(profile.q.begin(), profile.q.end(), from_) - profile.q.begin());
  for (; i < profile.size() && profile.q[i] < to_; ++i)
  {
    if (profile.q[i] < from_)
      continue;  // q rises but for noise, and for points that one row off the plane tells alone
    Cell& cell = cells_[static_cast<std::size_t>((profile.q[i] - from_) / kCell)];
    cell.weight += weight;
    cell.q += weight * profile.q[i];
    cell.above += weight * (profile.z[i] - parent.at(profile.q[i]));
  }
}

SectionProfile MeanOutline::above(const Line& parent, double least) const
{
  SectionProfile profile;
  for (const Cell& cell : cells_)
  {
    if (!(cell.weight > least))
      continue;
    profile.q.push_back(cell.q / cell.weight);
    profile.z.push_back(parent.at(profile.q.back()) + cell.above / cell.weight);
  }
  return profile;
}
}  // namespace weld
}  // namespace weld_profiler
