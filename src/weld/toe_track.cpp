#include "toe_track.h"

#include <algorithm>

namespace weld_profiler
{
namespace weld
{
namespace
{
bool measured(const SectionPoint& point)
{
  return point.x.measured() && point.y.measured() && point.z.measured();
}
}  // namespace

ToeTrack::ToeTrack(const WeldResult& result, const PathFrame& frame, double bridge) : bridge_(bridge)
{
  for (const WeldSection& section : result.sections)
  {
    if (!measured(section.toe_left) || !measured(section.toe_right))
      continue;
    const PathPlace left = frame.locate(section.toe_left.x.value, section.toe_left.y.value, section.s);
    const PathPlace right = frame.locate(section.toe_right.x.value, section.toe_right.y.value, section.s);
    const ToePair pair{ 0.5 * (left.s + right.s), left.q, right.q, section.toe_left.z.value,
                        section.toe_right.z.value };
    if (pair.left < pair.right && (pairs_.empty() || pair.s > pairs_.back().s))
      pairs_.push_back(pair);
  }
}

bool ToeTrack::has(double s) const
{
  if (pairs_.empty() || !(s >= pairs_.front().s && s <= pairs_.back().s))
    return false;
  const auto after = std::lower_bound(pairs_.begin(), pairs_.end(), s,
                                      [](const ToePair& pair, double value) { return pair.s < value; });
  return after->s == s || after->s - (after - 1)->s <= bridge_;
}

ToePair ToeTrack::at(double s) const
{
  const auto after = std::lower_bound(pairs_.begin(), pairs_.end(), s,
                                      [](const ToePair& pair, double value) { return pair.s < value; });
  if (after == pairs_.begin())
    return *after;
  const ToePair& a = *(after - 1);
  const ToePair& b = *after;
  const double share = (s - a.s) / (b.s - a.s);
  const auto between = [share](double from, double to) { return from + share * (to - from); };
  return { s, between(a.left, b.left), between(a.right, b.right), between(a.z_left, b.z_left),
           between(a.z_right, b.z_right) };
}
}  // namespace weld
}  // namespace weld_profiler
