#pragma once

#include <vector>

#include "seed.h"

namespace weld_profiler
{
/// Chooses in each column the candidate that lies on one line with its neighbours, or none.
///
/// The best path by dynamic programming along the stripe: bright candidates are rewarded, distance between neighbours
/// costs, a real step costs a fixed sum, so that a spark, a second reflection or a spatter does not pull the line off.
/// Fewer than 5 columns on their own are not taken.
class ContinuityTracker
{
public:
  /// @param otsu   threshold in grey levels; candidates above it weigh more.
  /// @param seeds  at most one a column, rising in u; empty = no stripe.
  void choose(const CandidateList& candidates, float otsu, std::vector<Seed>& seeds);

private:
  struct State
  {
    int u = 0;
    int candidate = 0;
    int previous = -1;
    float score = 0.0F;
    bool jumped = true;  ///< not continuous with the state before
  };

  float typicalBrightness(const CandidateList& candidates);
  void buildStates(const CandidateList& candidates, float otsu);
  void addState(const CandidateList& candidates, int u, int candidate, float reward);
  void prune(std::size_t carried);
  void collect(const CandidateList& candidates, std::vector<Seed>& seeds);

  std::vector<State> states_;
  std::vector<int> live_;
  std::vector<int> next_;
  std::vector<float> brightest_;
};

/// Drops pieces of fewer than least_cells seeds; pieces are parted by jumps and by gaps of more than 3 columns.
void dropShortPieces(std::vector<Seed>& seeds, int least_cells);
}  // namespace weld_profiler
