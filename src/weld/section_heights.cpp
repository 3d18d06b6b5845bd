#include "section_heights.h"

#include <algorithm>
#include <cmath>

#include "statistics.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr std::size_t kFewest = 5;  // points in a fit

std::size_t firstFrom(const SectionProfile& profile, double q)
{
  return static_cast<std::size_t>(std::lower_bound(profile.q.begin(), profile.q.end(), q) - profile.q.begin());
}

/// Sums of a parabola's regression, d from the node in units that keep them of one size.
struct Moments
{
  double d[5] = { 0.0, 0.0, 0.0, 0.0, 0.0 };
  double z[3] = { 0.0, 0.0, 0.0 };

  void add(double at, double height)
  {
    double power = 1.0;
    for (int i = 0; i < 5; ++i)
    {
      d[i] += power;
      if (i < 3)
        z[i] += power * height;
      power *= at;
    }
  }
};

/// Parabola through points [begin, end) about q; false where they do not determine one.
bool fitNode(const SectionProfile& profile, std::size_t begin, std::size_t end, double energy, HeightNode& node)
{
  constexpr double kUnit = 1e-4;  // [m]
  Moments sums;
  const double base = profile.z[begin];
  for (std::size_t i = begin; i < end; ++i)
    sums.add((profile.q[i] - node.q) / kUnit, profile.z[i] - base);
  const double* d = sums.d;
  // first row of the inverse of the normal matrix, and the last, by cofactors
  const double c00 = d[2] * d[4] - d[3] * d[3], c01 = d[3] * d[2] - d[1] * d[4], c02 = d[1] * d[3] - d[2] * d[2];
  const double c12 = d[1] * d[2] - d[0] * d[3], c22 = d[0] * d[2] - d[1] * d[1];
  const double det = d[0] * c00 + d[1] * c01 + d[2] * c02;
  if (!(det > 0.0) || !(c00 < 10.0 * det))
    return false;
  node.z = base + (c00 * sums.z[0] + c01 * sums.z[1] + c02 * sums.z[2]) / det;
  node.bend = 2.0 * (c02 * sums.z[0] + c12 * sums.z[1] + c22 * sums.z[2]) / det / square(kUnit);
  node.sigma = std::sqrt(energy * c00 / det);
  return true;
}
}  // namespace

std::vector<HeightNode> localHeights(const SectionProfile& profile, const HeightSpan& span)
{
  std::vector<HeightNode> nodes;
  const std::size_t first = firstFrom(profile, span.from);
  const std::size_t last = firstFrom(profile, span.to);
  std::size_t begin = first, end = first, after = first;
  for (double q = span.from; q <= span.to; q += span.step)
  {
    while (begin < last && profile.q[begin] < q - span.half_window)
      ++begin;
    while (end < last && profile.q[end] <= q + span.half_window)
      ++end;
    while (after < last && profile.q[after] < q)
      ++after;
    if (end < begin + kFewest)
      continue;
    const double before_q = after > first ? profile.q[after - 1] : span.from;
    const double after_q = after < last ? profile.q[after] : span.to;
    if (after_q - before_q > span.max_gap)
      continue;
    HeightNode node;
    node.q = q;
    if (fitNode(profile, begin, end, span.energy, node))
      nodes.push_back(node);
  }
  return nodes;
}

double longestGap(const SectionProfile& profile, double from, double to)
{
  double last = from, longest = 0.0;
  for (std::size_t i = firstFrom(profile, from); i < profile.size() && profile.q[i] <= to; ++i)
  {
    longest = std::max(longest, profile.q[i] - last);
    last = profile.q[i];
  }
  return std::max(longest, to - last);
}
}  // namespace weld
}  // namespace weld_profiler
