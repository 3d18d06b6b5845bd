#pragma once

#include <vector>

#include "group_peaks.h"

namespace weld_profiler
{
/// The peak that was taken for the stripe in one group.
struct PathNode
{
  static constexpr int kFree = 1 << 16;
  int group = 0;
  GroupPeak peak;
  int free_above = kFree;  ///< sampled rows to the nearest lower top of the group on that side
  int free_below = kFree;
  bool starts_piece = false;  ///< the stripe is torn between the node before and this one
  bool ambiguous = false;     ///< a second peak of this group was nearly as good
};

/// Chooses in each group the peak that lies on one line with its neighbours, or none.
///
/// The best path by dynamic programming along the stripe: bright peaks are rewarded, distance between neighbours costs,
/// a real step costs a fixed sum, so that a spark, a second reflection or a spatter does not pull the line off.
class GroupPath
{
public:
  /// @param nodes  at most one a group, rising; empty = no stripe.
  void choose(const GroupSums& sums, const GroupPeaks& peaks, std::vector<PathNode>& nodes);

private:
  struct State
  {
    int group = 0;
    int peak = 0;
    int previous = -1;
    float score = 0.0F;
    bool jumped = true;  ///< not continuous with the state before
  };

  float typicalHeight(const GroupSums& sums, const GroupPeaks& peaks);
  void addState(const GroupSums& sums, const GroupPeaks& peaks, State state, float reward);
  void prune();
  void collect(const GroupPeaks& peaks, std::vector<PathNode>& nodes) const;

  std::vector<State> states_;
  std::vector<int> live_;
  std::vector<int> next_;
  std::vector<int> heights_;
};

/// Drops pieces that stand alone and are not bright: less than two groups, and dimmer than half of the typical node.
void dropLoners(std::vector<PathNode>& nodes);
}  // namespace weld_profiler
