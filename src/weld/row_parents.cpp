#include "row_parents.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "statistics.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kClear = 3e-3;      // of a parent at the weld, that its line does without [m]
constexpr double kClearShare = 0.4;  // ... but no more than this share of it
constexpr int kRounds = 4;           // of the robust line through a run
constexpr int kMostAtEnd = 3;        // nodes of what follows that merging may have taken in
constexpr double kCertain = 3.0;     // sigmas of a bend

/// Tukey's biweight, begun at the run's own line: a low bead in a long run leaves it.
Line robustLine(const std::vector<Node>& nodes, const StraightRun& run, double least_scale)
{
  const double middle = 0.5 * (run.x_from + run.x_to);
  Line line = run.line;
  std::vector<double> residuals;
  residuals.reserve(static_cast<std::size_t>(run.end - run.first));
  for (int round = 0; round < kRounds; ++round)
  {
    residuals.clear();
    for (int i = run.first; i < run.end; ++i)
      residuals.push_back(nodes[static_cast<std::size_t>(i)].z - line.at(nodes[static_cast<std::size_t>(i)].x));
    const double scale = std::max(least_scale, robustSigma(residuals));
    double n = 0.0, x = 0.0, z = 0.0, xx = 0.0, xz = 0.0;
    for (int i = run.first; i < run.end; ++i)
    {
      const Node& node = nodes[static_cast<std::size_t>(i)];
      const double weight = tukey(residuals[static_cast<std::size_t>(i - run.first)] / scale);
      const double d = node.x - middle;
      n += weight, x += weight * d, z += weight * node.z, xx += weight * d * d, xz += weight * d * node.z;
    }
    const double spread = xx - x * x / n;
    if (!(spread > 0.0))
      return run.line;
    line.slope = (xz - x * z / n) / spread;
    line.height = (z - line.slope * x) / n - line.slope * middle;
  }
  return line;
}

/// The longest stretch of a run's nodes that lies above a line by more than `seen` and reaches min_height.
std::pair<int, int> bumpOf(const std::vector<Node>& nodes, const StraightRun& run, const Line& line, double seen,
                           const WeldParams& params)
{
  std::pair<int, int> longest(run.end, run.end);
  double length = params.min_width;
  for (int i = run.first; i < run.end; ++i)
  {
    const int begin = i;
    double top = 0.0;
    const auto rise = [&](int at)
    { return line.above(nodes[static_cast<std::size_t>(at)].x, nodes[static_cast<std::size_t>(at)].z); };
    for (; i < run.end && rise(i) > seen; ++i)
      top = std::max(top, rise(i));
    const double reach =
        i == begin ? 0.0 : nodes[static_cast<std::size_t>(i) - 1].x - nodes[static_cast<std::size_t>(begin)].x;
    if (top < params.min_height || reach < length)
      continue;
    longest = { begin, i };
    length = reach;
  }
  return longest;
}

/// Cuts a run at a bead so low that a straight line through it and its parents leaves little.
void splitAtBumps(const std::vector<Node>& nodes, double seen, const WeldParams& params, std::vector<StraightRun>& runs)
{
  std::vector<StraightRun> split;
  for (const StraightRun& run : runs)
  {
    const Line line = robustLine(nodes, run, 0.25 * seen);
    const std::pair<int, int> bump = bumpOf(nodes, run, line, seen, params);
    const auto x = [&nodes](int i) { return nodes[static_cast<std::size_t>(i)].x; };
    if (bump.first == run.end || bump.first == run.first || bump.second == run.end)
    {
      split.push_back(run);
      continue;
    }
    split.push_back(StraightRun{ run.first, bump.first, run.x_from, x(bump.first - 1), line });
    split.push_back(StraightRun{ bump.second, run.end, x(bump.second), run.x_to, line });
  }
  runs = std::move(split);
}

/// Whether something wider than spatter rises beyond a run's end, on side -1 or 1.
bool endsAtSomething(const std::vector<Node>& nodes, const StraightRun& run, int side, const Line& line, double seen,
                     double width)
{
  const auto at = [&nodes](int i) -> const Node& { return nodes[static_cast<std::size_t>(i)]; };
  const int last = side < 0 ? run.first : run.end - 1;
  const int size = static_cast<int>(nodes.size());
  int i = last + side * kMostAtEnd;  // nearer it may have just begun
  for (; i >= 0 && i < size && std::abs(at(i).x - at(last).x) < width; i += side)
  {
    if (!(line.above(at(i).x, at(i).z) > seen))
      return false;
  }
  return i != last + side * kMostAtEnd;
}

/// Takes the nodes off a run's ends that belong to what stands there: in a short piece between two things they tilt the
/// line. Up to the field's edge nothing follows.
void trimEnds(const std::vector<Node>& nodes, double seen, double width, StraightRun& run)
{
  if (run.first == 0 || run.end == static_cast<int>(nodes.size()) || run.length() > kClear / kClearShare)
    return;
  const Line line = robustLine(nodes, run, 0.25 * seen);
  if (!endsAtSomething(nodes, run, -1, line, seen, width) || !endsAtSomething(nodes, run, 1, line, seen, width))
    return;
  const auto at = [&nodes](int i) -> const Node& { return nodes[static_cast<std::size_t>(i)]; };
  const auto off = [&](int i) { return std::abs(line.above(at(i).x, at(i).z)) > seen; };
  int first = run.first, end = run.end;
  while (first < run.first + kMostAtEnd && first + 2 < end && off(first))
    ++first;
  while (end > run.end - kMostAtEnd && first + 2 < end && off(end - 1))
    --end;
  if (first != run.first || end != run.end)
    run = StraightRun{ first, end, at(first).x, at(end - 1).x, line };
}

/// Bulges more than a parent may, which is straight within `flatness` over `parent_length`: a piece of a bead's face.
/// Told from the medians of thirds, which spatter leaves alone, without the end at the weld, where a toe or an undercut
/// bends a plate, too.
/// @param side  of the weld that the run lies on, -1 or 1.
bool bulges(const std::vector<Node>& nodes, const StraightRun& run, int side, double noise, const WeldParams& params)
{
  constexpr double kParabola = 3.354;  // its rise over its scatter about a line: sqrt(45 / 4)
  const int clear = static_cast<int>(kClearShare * (run.end - run.first));
  const int first = side > 0 ? run.first + clear : run.first, end = side > 0 ? run.end : run.end - clear;
  const int third = (end - first) / 3;
  if (third < 1)
    return false;
  std::vector<double> off;
  const auto middle = [&](int from)
  {
    off.clear();
    for (int i = from; i < from + third; ++i)
    {
      const Node& node = nodes[static_cast<std::size_t>(i)];
      off.push_back(node.z - run.line.at(node.x));
    }
    return medianInPlace(off);
  };
  const double bulge = middle((first + end - third) / 2) - 0.5 * (middle(first) + middle(end - third));
  const double length = nodes[static_cast<std::size_t>(end) - 1].x - nodes[static_cast<std::size_t>(first)].x;
  const double allowed = 4.0 / 9.0 * kParabola * params.flatness * square(length / params.parent_length);
  // nodes err alike over a millimetre: a third's median is hardly better than one of them
  return bulge > allowed + kCertain * noise * std::sqrt(1.5);
}
}  // namespace

std::vector<StraightRun> rowParents(const std::vector<Node>& nodes, double noise, double seen, const WeldParams& params)
{
  const double tolerance = std::max(params.flatness, 2.0 * noise);
  std::vector<StraightRun> runs = straightRuns(nodes, tolerance);
  splitAtBumps(nodes, seen, params, runs);
  for (StraightRun& run : runs)
    trimEnds(nodes, seen, 2.0 * params.min_width, run);
  runs.erase(std::remove_if(runs.begin(), runs.end(),
                            [&](const StraightRun& run) { return run.length() < params.min_parent_length; }),
             runs.end());
  // what lies between two parents is told from them; the outermost have nothing beyond
  while (!runs.empty() && bulges(nodes, runs.back(), 1, noise, params))
    runs.pop_back();
  runs.erase(runs.begin(),
             std::find_if_not(runs.begin(), runs.end(),
                              [&](const StraightRun& run) { return bulges(nodes, run, -1, noise, params); }));
  return runs;
}

Line clearLine(const std::vector<Node>& nodes, const StraightRun& run, int side, double length)
{
  const double end = side < 0 ? run.x_to : run.x_from;
  const double clear = std::min(kClear, kClearShare * run.length());
  const auto at = [&nodes](int i) -> const Node& { return nodes[static_cast<std::size_t>(i)]; };
  // as x rises, so those outward of one place and inward of another follow each other
  const auto taken = [&](int i)
  {
    const double outward = side * (at(i).x - end);
    return outward >= clear && outward <= clear + length;
  };
  int first = run.first, last = run.end;
  while (first < last && !taken(first))
    ++first;
  while (last > first && !taken(last - 1))
    --last;
  if (last - first < 6)
    return run.line;
  std::vector<double> x, z;
  const auto middle = [&](int from, int to)
  {
    x.clear();
    z.clear();
    for (int i = from; i < to; ++i)
    {
      x.push_back(at(i).x);
      z.push_back(at(i).z - run.line.at(at(i).x));
    }
    return std::make_pair(medianInPlace(x), medianInPlace(z));
  };
  const int third = (last - first) / 3;
  const auto near = middle(first, first + third), far = middle(last - third, last);
  const double slope = (far.second - near.second) / (far.first - near.first);
  return Line{ run.line.height + near.second - slope * near.first, run.line.slope + slope };
}
}  // namespace weld
}  // namespace weld_profiler
