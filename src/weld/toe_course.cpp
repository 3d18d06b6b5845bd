#include "toe_course.h"

#include <algorithm>
#include <cmath>

#include "statistics.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr std::size_t kFewest = 4;  // toes that make a course

/// Where a straight line through toes at distances d leads to at d = 0: slope by repeated medians, height in the
/// median, so that nearly half of the toes may be wrong (Siegel 1982).
double leadsTo(const std::vector<double>& d, const std::vector<double>& q)
{
  if (d.size() < kFewest)
    return kNaN;
  std::vector<double> slopes, to_others, heights;
  slopes.reserve(d.size());
  heights.reserve(d.size());
  for (std::size_t i = 0; i < d.size(); ++i)
  {
    to_others.clear();
    for (std::size_t j = 0; j < d.size(); ++j)
    {
      if (j != i)
        to_others.push_back((q[j] - q[i]) / (d[j] - d[i]));
    }
    slopes.push_back(median(to_others));
  }
  const double slope = median(std::move(slopes));
  for (std::size_t i = 0; i < d.size(); ++i)
    heights.push_back(q[i] - slope * d[i]);
  return median(std::move(heights));
}

double innerOf(Side side, double a, double b)
{
  return side == Side::Left ? std::max(a, b) : std::min(a, b);
}
}  // namespace

AlongWeld toeCourse(const std::vector<double>& s, const AlongWeld& toes, Side side, double window)
{
  AlongWeld result = toes;
  for (std::size_t k = 0; k < s.size(); ++k)
  {
    const double own = toes.value[k];
    if (!std::isfinite(own))
      continue;
    std::vector<double> d_before, q_before, d_behind, q_behind;
    for (std::size_t j = 0; j < s.size(); ++j)
    {
      const double d = s[j] - s[k];
      if (j == k || !std::isfinite(toes.value[j]) || std::abs(d) > window)
        continue;
      (d < 0.0 ? d_before : d_behind).push_back(d);
      (d < 0.0 ? q_before : q_behind).push_back(toes.value[j]);
    }
    const double before = leadsTo(d_before, q_before), behind = leadsTo(d_behind, q_behind);
    const double other = std::isfinite(before) ? before : behind;
    if (std::isfinite(before) && std::isfinite(behind))
      result.value[k] = std::max(std::min(before, behind), std::min(std::max(before, behind), own));
    else if (std::isfinite(other))
      result.value[k] = innerOf(side, own, other);
  }
  return result;
}
}  // namespace weld
}  // namespace weld_profiler
