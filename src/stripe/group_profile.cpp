#include "group_profile.h"

#include <algorithm>
#include <cmath>

#include "medians.h"

namespace weld_profiler
{
namespace
{
constexpr float kFwhmPerSigma = 2.355F;
constexpr float kFlankSigmas = 4.0F;  // where the background begins
constexpr float kClearSigmas = 2.5F;  // that another top must stay off it
constexpr int kFlankSamples = 3;
constexpr float kFoot = 0.2F;  // share of the height below which samples do not count for the centre

/// Rows, from the top's, at which the profile falls through half of its height on one side.
float halfWidth(const GroupSums& sums, const PathNode& node, int side)
{
  const float half = node.peak.top - 0.5F * node.peak.height;
  float before = node.peak.top;
  const int reach = std::max(1, GroupPeaks::kReach / sums.rowStep());
  for (int i = 1; i <= reach; ++i)
  {
    const int row = node.peak.row + side * i;
    if (row < 0 || row >= sums.rows())
      return static_cast<float>(i);
    const float here = sums.row(row)[node.group];
    if (here <= half)
      return static_cast<float>(i - 1) + (before - half) / std::max(1.0F, before - here);
    before = here;
  }
  return static_cast<float>(reach);
}

/// Level of one flank; negative = outside the image.
float flank(const GroupSums& sums, int group, int first)
{
  if (first < 0 || first + kFlankSamples > sums.rows())
    return -1.0F;
  return median3(sums.row(first)[group], sums.row(first + 1)[group], sums.row(first + 2)[group]);
}
}  // namespace

GroupProfile measureGroup(const GroupSums& sums, const PathNode& node)
{
  const auto step = static_cast<float>(sums.rowStep());
  const float left = halfWidth(sums, node, -1);
  const float right = halfWidth(sums, node, 1);
  GroupProfile result;
  result.u = sums.middle(node.group);
  result.sigma = std::max(GroupProfile::kNarrowest, step * (left + right) / kFwhmPerSigma);
  result.starts_piece = node.starts_piece;
  result.ambiguous = node.ambiguous ? 1.0F : 0.0F;

  const float floor = node.peak.top - (1.0F - kFoot) * node.peak.height;
  float weight = 0.0F;
  float moment = 0.0F;
  const int first = std::max(0, node.peak.row - static_cast<int>(std::ceil(left)));
  const int last = std::min(sums.rows() - 1, node.peak.row + static_cast<int>(std::ceil(right)));
  for (int i = first; i <= last; ++i)
  {
    const float light = std::max(0.0F, sums.row(i)[node.group] - floor);
    weight += light;
    moment += light * static_cast<float>(i);
  }
  const float middle = moment / std::max(1.0F, weight);
  result.v = step * middle;

  const int reach = static_cast<int>(std::ceil(kFlankSigmas * result.sigma / step));
  const int centre = static_cast<int>(std::lround(middle));
  // Where another top stands in a flank, the light there is not the background.
  const int clear = reach + kFlankSamples + static_cast<int>(std::ceil(kClearSigmas * result.sigma / step));
  const bool free_above = node.free_above > clear || node.free_below <= clear;
  const bool free_below = node.free_below > clear || node.free_above <= clear;
  const float above = free_above ? flank(sums, node.group, centre - reach - kFlankSamples + 1) : -1.0F;
  const float below = free_below ? flank(sums, node.group, centre + reach) : -1.0F;
  const float base = node.peak.top - node.peak.height;
  if (above >= 0.0F && below >= 0.0F)
  {
    result.background = 0.5F * (above + below);
    result.gradient = (below - above) / (step * static_cast<float>(2 * reach + kFlankSamples - 1));
  }
  else
    result.background = above >= 0.0F ? above : (below >= 0.0F ? below : base);
  result.background /= sums.perLevel();
  result.gradient /= sums.perLevel();
  result.span = step * static_cast<float>(2 * reach + kFlankSamples - 1);
  return result;
}
}  // namespace weld_profiler
