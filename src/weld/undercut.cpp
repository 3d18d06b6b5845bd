#include "undercut.h"

#include <algorithm>
#include <cmath>

#include "section_heights.h"
#include "statistics.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kHalfWindow = 1.1e-4;  // of the local fits [m]
constexpr double kStep = 2.5e-5;        // between them [m]
constexpr double kEdge = 3e-4;          // without points this near outside the toe nothing is said of an undercut [m]
constexpr double kSeen = 1e-4;        // nodes further apart than one and a half of these have a break between them [m]
constexpr double kSure = 3.0;         // sigmas of a depth that is beyond doubt
constexpr double kRim = 0.1;          // of the depth: the groove ends where it is shallower
constexpr double kGrooveBlur = 5e-5;  // 1-sigma of what stripe and fit blur a groove by [m]
constexpr double kUsualBlunt = 1.5e-5;  // by which this makes a groove of usual width shallower [m]
constexpr double kSlopeBlur = 1.5e-6;   // what the blur of kinks leaves beside a toe [m]
/// Whether a groove's bottom may lie where too few points were seen.
bool deeperInABreak(const std::vector<HeightNode>& nodes, const Line& line)
{
  std::vector<HeightNode> turned = nodes;
  for (HeightNode& node : turned)
    node.z = -node.z;
  return !largestAbove(turned, Line{ -line.height, -line.slope }, kSeen).measured();
}
}  // namespace

Undercut measureUndercut(const SectionProfile& profile, const SectionShape& shape, Side side, const WeldParams& params)
{
  Undercut result;
  const ToeFit& toe = shape.toe(side);
  const ParentFit& parent = shape.parent(side);
  if (!toe.found || !parent.valid())
    return result;
  const double end = toe.q + sign(side) * params.undercut_reach;
  HeightSpan span;
  span.from = std::min(toe.q, end), span.to = std::max(toe.q, end);
  span.half_window = kHalfWindow;
  span.step = kStep;
  span.max_gap = 0.5 * params.max_gap;
  span.energy = 2.0 * shape.energy();
  if (longestGap(profile, span.from, span.to) > params.max_gap)
    return result;
  const std::vector<HeightNode> nodes = localHeights(profile, span);
  double deepest = 0.0, bend = 0.0;
  std::size_t at = nodes.size();
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    const double depth = -parent.line.above(nodes[i].q, nodes[i].z);
    if (!(depth > deepest) && at < nodes.size())
      continue;
    deepest = std::max(depth, 0.0);
    bend = nodes[i].bend;
    at = i;
  }
  if (at < nodes.size() && deeperInABreak(nodes, parent.line))
    return result;
  if (at == nodes.size() || std::min(std::abs(nodes.front().q - toe.q), std::abs(nodes.back().q - toe.q)) > kEdge)
    return result;
  result.depth.value = deepest;
  // rows that cross the groove obliquely blur it, too, as they are interpolated, and with it how bent it seems
  const double oblique = profile.row_pitch * std::tan(profile.place.yaw) / std::sqrt(6.0);
  const double blunt = std::max(0.0, std::abs(bend) * (0.5 * square(kGrooveBlur) + square(oblique)) - kUsualBlunt);
  result.depth.sigma =
      std::sqrt(square(nodes[at].sigma) + square(parent.sigmaAt(nodes[at].q)) + square(kSlopeBlur) + square(blunt));
  if (deepest < kSure * result.depth.sigma)
    return result;
  // a groove that goes on where no more was seen
  if (at == 0 || at + 1 == nodes.size())
    return Undercut();
  for (const HeightNode& node : nodes)
  {
    if (-parent.line.above(node.q, node.z) > std::max(kRim * deepest, 2.0 * result.depth.sigma))
      result.width = std::max(result.width, std::abs(node.q - toe.q));
  }
  return result;
}
}  // namespace weld
}  // namespace weld_profiler
