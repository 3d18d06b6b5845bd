#include "continuity.h"

#include <algorithm>
#include <cmath>

namespace weld_profiler
{
namespace
{
constexpr float kJumpCost = 5.0F;   ///< of a step, in columns of a full reward
constexpr float kFreeSlope = 1.5F;  ///< rows a column that cost next to nothing: 56 deg
constexpr float kFreeSigmas = 0.5F;
constexpr float kSlopeCost = 0.03F;    ///< per row: of two ways equally bright the straighter
constexpr float kRoughCost = 0.8F;     ///< per row beyond the free slope
constexpr float kWeak = 0.6F;          ///< reward of a candidate below Otsu's threshold
constexpr float kBrightEnough = 0.5F;  ///< brightness, of the typical, that earns the full reward
constexpr float kBonus = 0.1F;         ///< share of the reward that tells bright from brighter: a long reflection that
                                       ///< outshines the stripe for a while must not pay for two jumps
constexpr float kAmbiguous = 0.5F;     ///< brightness, of the chosen, from which a second candidate is worth a flag
constexpr std::size_t kLive = 12;      ///< ends of paths followed at once
constexpr int kSmallGap = 3;           ///< columns that may be missing inside a piece

/// @param sigma  of the wider of the two: the top of a wide, speckled stripe is found to a fraction of its width.
float transitionCost(int columns, float rows, float sigma)
{
  const float distance = std::abs(rows);
  const float rough =
      std::max(0.0F, distance - kFreeSlope * static_cast<float>(columns) - std::max(1.0F, kFreeSigmas * sigma));
  return std::min(kJumpCost, kSlopeCost * distance + kRoughCost * rough);
}
}  // namespace

void ContinuityTracker::choose(const CandidateList& candidates, float otsu, std::vector<Seed>& seeds)
{
  seeds.clear();
  if (candidates.items.empty())
    return;
  buildStates(candidates, otsu);
  collect(candidates, seeds);
}

/// Median over the columns of their brightest candidate.
float ContinuityTracker::typicalBrightness(const CandidateList& candidates)
{
  brightest_.clear();
  const int columns = static_cast<int>(candidates.first.size()) - 1;
  for (int u = 0; u < columns; ++u)
  {
    float most = 0.0F;
    for (int i = candidates.first[u]; i < candidates.first[u + 1]; ++i)
      most = std::max(most, candidates.items[i].brightness);
    if (most > 0.0F)
      brightest_.push_back(most);
  }
  const auto middle = brightest_.begin() + static_cast<std::ptrdiff_t>(brightest_.size() / 2);
  std::nth_element(brightest_.begin(), middle, brightest_.end());
  return *middle;
}

void ContinuityTracker::buildStates(const CandidateList& candidates, float otsu)
{
  const float typical = typicalBrightness(candidates);
  states_.clear();
  live_.clear();
  const int columns = static_cast<int>(candidates.first.size()) - 1;
  for (int u = 0; u < columns; ++u)
  {
    next_.clear();
    for (int i = candidates.first[u]; i < candidates.first[u + 1]; ++i)
    {
      const Candidate& candidate = candidates.items[i];
      const float reward = (1.0F - kBonus) * std::min(1.0F, candidate.brightness / (kBrightEnough * typical)) +
                           kBonus * candidate.brightness / (candidate.brightness + typical);
      addState(candidates, u, i, candidate.top > otsu ? reward : kWeak * reward);
    }
    next_.insert(next_.end(), live_.begin(), live_.end());
    live_.swap(next_);
    prune(kLive);
  }
}

void ContinuityTracker::addState(const CandidateList& candidates, int u, int candidate, float reward)
{
  State state;
  state.u = u;
  state.candidate = candidate;
  for (const int index : live_)
  {
    const State& before = states_[index];
    const Candidate& from = candidates.items[before.candidate];
    const Candidate& to = candidates.items[candidate];
    const float cost = transitionCost(u - before.u, to.v - from.v, std::max(from.sigma, to.sigma));
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
void ContinuityTracker::prune(std::size_t most)
{
  if (live_.empty())
    return;
  const auto better = [this](int a, int b) { return states_[a].score > states_[b].score; };
  std::sort(live_.begin(), live_.end(), better);
  const float least = states_[live_.front()].score - kJumpCost;
  std::size_t kept = std::min(live_.size(), most);
  while (kept > 1 && states_[live_[kept - 1]].score < least)
    --kept;
  live_.resize(kept);
}

void ContinuityTracker::collect(const CandidateList& candidates, std::vector<Seed>& seeds)
{
  for (int index = live_.empty() ? -1 : live_.front(); index >= 0; index = states_[index].previous)
  {
    const State& state = states_[index];
    const Candidate& candidate = candidates.items[state.candidate];
    Seed seed;
    seed.u = state.u;
    seed.v = candidate.v;
    seed.sigma = candidate.sigma;
    seed.brightness = candidate.brightness;
    seed.starts_piece = state.previous < 0 || state.jumped;
    for (int i = candidates.first[state.u]; i < candidates.first[state.u + 1]; ++i)
      if (i != state.candidate && candidates.items[i].brightness > kAmbiguous * candidate.brightness)
        seed.ambiguous = true;
    seeds.push_back(seed);
  }
  std::reverse(seeds.begin(), seeds.end());
}

void dropShortPieces(std::vector<Seed>& seeds, int least_cells)
{
  std::size_t kept = 0;
  for (std::size_t begin = 0; begin < seeds.size();)
  {
    seeds[begin].starts_piece = true;
    std::size_t end = begin + 1;
    while (end < seeds.size() && !seeds[end].starts_piece && seeds[end].u - seeds[end - 1].u <= kSmallGap + 1)
      ++end;
    if (end - begin >= static_cast<std::size_t>(least_cells))
    {
      std::copy(seeds.begin() + static_cast<std::ptrdiff_t>(begin), seeds.begin() + static_cast<std::ptrdiff_t>(end),
                seeds.begin() + static_cast<std::ptrdiff_t>(kept));
      kept += end - begin;
    }
    begin = end;
  }
  seeds.resize(kept);
}
}  // namespace weld_profiler
