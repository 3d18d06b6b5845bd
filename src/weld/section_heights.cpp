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
constexpr std::size_t kFewest = 5;     // points in a fit
constexpr double kParabola = 3.0;      // values that one has
constexpr double kCourse = 8;          // nodes that tell how the face goes on into a break ...
constexpr double kFewestOfCourse = 3;  // ... and at least
constexpr double kHidden = 2.0;        // sigmas by which it may rise higher there before it is said
constexpr double kGuessed = 0.7;       // of a height's sigma, from where it is for want of rows

std::size_t firstFrom(const SectionProfile& profile, double q)
{
  return static_cast<std::size_t>(std::lower_bound(profile.q.begin(), profile.q.end(), q) - profile.q.begin());
}

/// Sums of a parabola's regression, d from the node in units that keep them of one size.
struct Moments
{
  double d[5] = { 0.0, 0.0, 0.0, 0.0, 0.0 };
  double z[3] = { 0.0, 0.0, 0.0 };
  double zz = 0.0;

  void add(double at, double height)
  {
    double power = 1.0;
    zz += height * height;
    for (int i = 0; i < 5; ++i)
    {
      d[i] += power;
      if (i < 3)
        z[i] += power * height;
      power *= at;
    }
  }
};

/// What a parabola through points [begin, end) may err by for the ripples between their rows, which move all of them
/// alike.
void addBetweenRows(const SectionProfile& profile, std::size_t begin, std::size_t end, double row_bend,
                    HeightNode& node)
{
  if (!(row_bend > 0.0) || profile.between.empty())
    return;
  double sum = 0.0;
  std::size_t lone = 0;
  for (std::size_t i = begin; i < end; ++i)
  {
    sum += std::abs(static_cast<double>(profile.between[i]));
    lone += profile.between[i] < 0.0F ? 1 : 0;
  }
  node.lone = 2 * lone > end - begin;
  node.between = row_bend * sum / static_cast<double>(end - begin);
}

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
  const double c11 = d[0] * d[4] - d[2] * d[2];
  const double a = (c00 * sums.z[0] + c01 * sums.z[1] + c02 * sums.z[2]) / det;
  const double b = (c01 * sums.z[0] + c11 * sums.z[1] + c12 * sums.z[2]) / det;
  const double c = (c02 * sums.z[0] + c12 * sums.z[1] + c22 * sums.z[2]) / det;
  node.z = base + a;
  node.bend = 2.0 * c / square(kUnit);
  // what points scatter beyond their noise comes of ripples between rows that are missing: it has one sign on a crest
  const double squares = sums.zz - a * sums.z[0] - b * sums.z[1] - c * sums.z[2];
  const double beyond = d[0] > kParabola ? squares / (d[0] - kParabola) - energy : 0.0;
  node.sigma = std::sqrt(energy * c00 / det + std::max(beyond, square(node.between)));
  return true;
}

/// The straight course of the nodes from `begin` on, which lead up to a break, in one direction, as far as they are
/// seen without another; invalid of too few.
Line courseOf(const std::vector<HeightNode>& nodes, std::size_t begin, int direction, double step)
{
  double n = 0.0, q = 0.0, z = 0.0, qq = 0.0, qz = 0.0;
  for (std::size_t i = begin; i < nodes.size() && n < kCourse; i += static_cast<std::size_t>(direction))
  {
    if (i != begin && std::abs(nodes[i].q - nodes[i - static_cast<std::size_t>(direction)].q) > 1.5 * step)
      break;
    const double d = nodes[i].q - nodes[begin].q, rise = nodes[i].z - nodes[begin].z;
    n += 1.0, q += d, z += rise, qq += d * d, qz += d * rise;
  }
  const double spread = qq - q * q / n;
  if (n < kFewestOfCourse || !(spread > 0.0))
    return Line();
  const double slope = (qz - q * z / n) / spread;
  const double height = nodes[begin].z + z / n - slope * (nodes[begin].q + q / n);
  return Line{ height, slope };
}

/// Height above the line of where both sides' courses meet in the break behind node i: a face that bulges stays below.
/// Infinite where a side is not seen.
double mayRiseTo(const std::vector<HeightNode>& nodes, std::size_t i, const Line& line, double step)
{
  const Line before = courseOf(nodes, i, -1, step);
  const Line after = courseOf(nodes, i + 1, 1, step);
  if (!before.valid() || !after.valid())
    return INFINITY;
  const double q = (after.height - before.height) / (before.slope - after.slope);
  const bool inside = q > nodes[i].q && q < nodes[i + 1].q;
  return inside ? line.above(q, before.at(q)) : -INFINITY;
}

/// 1-sigma of the highest node's height: another, not much lower, may be the highest for what lies between its rows.
double topSigma(const std::vector<HeightNode>& nodes, std::size_t best, const Line& line, double top)
{
  double higher = 0.0;
  for (const HeightNode& node : nodes)
    higher = std::max(higher, line.above(node.q, node.z) + node.between - top);
  return std::sqrt(square(nodes[best].sigma) - square(nodes[best].between) +
                   square(std::max(higher, nodes[best].between)));
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
    addBetweenRows(profile, begin, end, span.row_bend, node);
    if (fitNode(profile, begin, end, span.energy, node))
      nodes.push_back(node);
  }
  return nodes;
}

std::vector<HeightNode> withoutGuessed(const std::vector<HeightNode>& nodes, double step)
{
  const auto guessed = [](const HeightNode& node) { return node.lone && node.between > kGuessed * node.sigma; };
  std::vector<char> taken(nodes.size(), 1);
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
  {
    if (!(nodes[i + 1].q - nodes[i].q > 1.5 * step))
      continue;
    for (std::size_t j = i + 1; j > 0 && guessed(nodes[j - 1]); --j)
      taken[j - 1] = 0;
    for (std::size_t j = i + 1; j < nodes.size() && guessed(nodes[j]); ++j)
      taken[j] = 0;
  }
  std::vector<HeightNode> rest;
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    if (taken[i] != 0)
      rest.push_back(nodes[i]);
  }
  return rest;
}

Quantity largestAbove(const std::vector<HeightNode>& nodes, const Line& line, double step, std::size_t rims)
{
  std::size_t best = nodes.size();
  double top = -INFINITY;
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    const double above = line.above(nodes[i].q, nodes[i].z);
    if (!(above > top))
      continue;
    top = above;
    best = i;
  }
  if (best == nodes.size())
    return Quantity();
  for (std::size_t i = rims; i + 1 + rims < nodes.size(); ++i)
  {
    if (nodes[i + 1].q - nodes[i].q < 1.5 * step)
      continue;
    const bool beside = i == best || i + 1 == best;
    if (beside || mayRiseTo(nodes, i, line, step) > top + kHidden * nodes[best].sigma)
      return Quantity();
  }
  const double sigma = topSigma(nodes, best, line, top);
  if (best > 0 && best + 1 < nodes.size())
  {
    const double behind = nodes[best].q - nodes[best - 1].q, ahead = nodes[best + 1].q - nodes[best].q;
    if (std::abs(ahead - behind) > 0.5 * std::min(ahead, behind))
      return Quantity{ top, sigma };  // a break, whose other side tells no bend
    // between nodes the surface bends as the fit says
    const double before = line.above(nodes[best - 1].q, nodes[best - 1].z);
    const double after = line.above(nodes[best + 1].q, nodes[best + 1].z);
    const double bend = before - 2.0 * top + after;
    if (bend < 0.0)
      top -= square(after - before) / (8.0 * bend);
  }
  return Quantity{ top, sigma };
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
