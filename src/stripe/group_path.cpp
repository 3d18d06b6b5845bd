#include "group_path.h"

#include <algorithm>
#include <cmath>

namespace weld_profiler
{
namespace
{
// Costs and rewards are counted in groups of a full reward.
constexpr float kJumpCost = 0.9F;
constexpr float kFreeSlope = 1.8F;     // rows a column that cost next to nothing: 61 deg
constexpr float kFreeRows = 5.0F;      // a top is found to a sampled row
constexpr float kSlopeCost = 0.004F;   // per row: of two ways equally bright the straighter
constexpr float kRoughCost = 0.06F;    // per row beyond the free slope
constexpr float kBrightEnough = 0.5F;  // height, of the typical, that earns the full reward
constexpr float kBonus = 0.1F;         // share of the reward that tells bright from brighter: a long reflection that
                                       // outshines the stripe for a while must not pay for two jumps
constexpr int kFew = 2;                // tops of a group that are a stripe and what lies beside it
constexpr float kLower = 0.75F;        // height, of the chosen, of a top that is none of its own kind
constexpr float kAmbiguous = 0.5F;     // height, of the chosen, from which a second peak is worth a flag
constexpr std::size_t kLive = 12;      // ends of paths followed at once
constexpr int kSmallGap = 2;           // groups that may be missing inside a piece

float transitionCost(float columns, float rows)
{
  const float distance = std::abs(rows);
  const float rough = std::max(0.0F, distance - kFreeSlope * columns - kFreeRows);
  return std::min(kJumpCost, kSlopeCost * distance + kRoughCost * rough);
}
}  // namespace

void GroupPath::choose(const GroupSums& sums, const GroupPeaks& peaks, std::vector<PathNode>& nodes)
{
  nodes.clear();
  states_.clear();
  live_.clear();
  const float typical = typicalHeight(sums, peaks);
  for (int group = 0; group < sums.groups(); ++group)
  {
    next_.clear();
    for (int i = 0; i < peaks.size(group); ++i)
    {
      const float height = peaks.at(group, i).height;
      const float reward =
          (1.0F - kBonus) * std::min(1.0F, height / (kBrightEnough * typical)) + kBonus * height / (height + typical);
      State state;
      state.group = group;
      state.peak = i;
      addState(sums, peaks, state, reward);
    }
    next_.insert(next_.end(), live_.begin(), live_.end());
    live_.swap(next_);
    prune();
  }
  collect(peaks, nodes);
}

/// Median over the groups of their highest peak.
float GroupPath::typicalHeight(const GroupSums& sums, const GroupPeaks& peaks)
{
  heights_.clear();
  for (int group = 0; group < sums.groups(); ++group)
  {
    int most = 0;
    for (int i = 0; i < peaks.size(group); ++i)
      most = std::max<int>(most, peaks.at(group, i).height);
    if (most > 0)
      heights_.push_back(most);
  }
  if (heights_.empty())
    return 1.0F;
  const auto middle = heights_.begin() + static_cast<std::ptrdiff_t>(heights_.size() / 2);
  std::nth_element(heights_.begin(), middle, heights_.end());
  return static_cast<float>(*middle);
}

void GroupPath::addState(const GroupSums& sums, const GroupPeaks& peaks, State state, float reward)
{
  const float middle = sums.middle(state.group);
  const int row = peaks.at(state.group, state.peak).row;
  for (const int index : live_)
  {
    const State& before = states_[static_cast<std::size_t>(index)];
    if (before.score <= state.score)
      continue;
    const int rows = row - peaks.at(before.group, before.peak).row;
    const float cost = transitionCost(middle - sums.middle(before.group), static_cast<float>(rows * sums.rowStep()));
    if (before.score - cost > state.score)
    {
      state.score = before.score - cost;
      state.previous = index;
      state.jumped = cost >= kJumpCost;
    }
  }
  state.score += reward;
  next_.push_back(static_cast<int>(states_.size()));
  states_.push_back(state);
}

/// Keeps the best ends. One that lies more than a jump behind the best can never win again.
void GroupPath::prune()
{
  if (live_.size() < 2)
    return;
  const auto score = [this](int i) { return states_[static_cast<std::size_t>(i)].score; };
  std::sort(live_.begin(), live_.end(), [&](int a, int b) { return score(a) > score(b); });
  const float least = score(live_.front()) - kJumpCost;
  std::size_t kept = std::min(live_.size(), kLive);
  while (kept > 1 && score(live_[kept - 1]) < least)
    --kept;
  live_.resize(kept);
}

void GroupPath::collect(const GroupPeaks& peaks, std::vector<PathNode>& nodes) const
{
  int best = -1;
  for (const int index : live_)
    if (best < 0 || states_[static_cast<std::size_t>(index)].score > states_[static_cast<std::size_t>(best)].score)
      best = index;
  for (int index = best; index >= 0; index = states_[static_cast<std::size_t>(index)].previous)
  {
    const State& state = states_[static_cast<std::size_t>(index)];
    PathNode node;
    node.group = state.group;
    node.peak = peaks.at(state.group, state.peak);
    node.starts_piece = state.previous < 0 || state.jumped;
    for (int i = 0; i < peaks.size(state.group); ++i)
    {
      if (i == state.peak)
        continue;
      const GroupPeak& other = peaks.at(state.group, i);
      const int below = other.row - node.peak.row;
      const auto height = static_cast<float>(other.height);
      int& room = below > 0 ? node.free_below : node.free_above;
      // A pattern's tops are many, and all alike.
      if (peaks.size(state.group) <= kFew && height < kLower * static_cast<float>(node.peak.height))
        room = std::min(room, std::abs(below));
      node.ambiguous |= height > kAmbiguous * static_cast<float>(node.peak.height);
    }
    nodes.push_back(node);
  }
  std::reverse(nodes.begin(), nodes.end());
  for (std::size_t i = 1; i < nodes.size(); ++i)
    nodes[i].starts_piece |= nodes[i].group - nodes[i - 1].group > kSmallGap + 1;
}

void dropLoners(std::vector<PathNode>& nodes)
{
  float sum = 0.0F;
  for (const PathNode& node : nodes)
    sum += node.peak.height;
  const float least = 0.5F * sum / static_cast<float>(std::max<std::size_t>(1, nodes.size()));
  std::size_t kept = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    const bool alone = nodes[i].starts_piece && (i + 1 == nodes.size() || nodes[i + 1].starts_piece);
    if (!alone || nodes[i].peak.height >= least)
      nodes[kept++] = nodes[i];
  }
  nodes.resize(kept);
}
}  // namespace weld_profiler
