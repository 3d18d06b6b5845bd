#include "row_parents.h"

#include <algorithm>

#include "statistics.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kClear = 3e-3;      // of a parent at the weld, that its line does without [m]
constexpr double kClearShare = 0.4;  // ... but no more than this share of it
}  // namespace

std::vector<StraightRun> rowParents(const std::vector<Node>& nodes, double noise, const WeldParams& params)
{
  const double tolerance = std::max(params.flatness, 2.0 * noise);
  std::vector<StraightRun> runs = straightRuns(nodes, tolerance);
  runs.erase(std::remove_if(runs.begin(), runs.end(),
                            [&](const StraightRun& run) { return run.length() < params.min_parent_length; }),
             runs.end());
  return runs;
}

Line clearLine(const std::vector<Node>& nodes, const StraightRun& run, int side, double length)
{
  const double end = side < 0 ? run.x_to : run.x_from;
  const double clear = std::min(kClear, kClearShare * run.length());
  std::vector<Node> part;
  for (int i = run.first; i < run.end; ++i)
  {
    const Node& node = nodes[static_cast<std::size_t>(i)];
    const double outward = side * (node.x - end);
    if (outward >= clear && outward <= clear + length)
      part.push_back(node);
  }
  if (part.size() < 6)
    return run.line;
  const auto third = static_cast<std::ptrdiff_t>(part.size() / 3);
  const auto middle = [&run](std::vector<Node>::const_iterator from, std::vector<Node>::const_iterator to)
  {
    std::vector<double> x, z;
    std::transform(from, to, std::back_inserter(x), [](const Node& node) { return node.x; });
    std::transform(from, to, std::back_inserter(z), [&run](const Node& node) { return node.z - run.line.at(node.x); });
    return std::make_pair(median(std::move(x)), median(std::move(z)));
  };
  const auto near = middle(part.cbegin(), part.cbegin() + third), far = middle(part.cend() - third, part.cend());
  const double slope = (far.second - near.second) / (far.first - near.first);
  return Line{ run.line.height + near.second - slope * near.first, run.line.slope + slope };
}
}  // namespace weld
}  // namespace weld_profiler
