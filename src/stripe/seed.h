#pragma once

#include <vector>

namespace weld_profiler
{
/// A rise in one column that could be the stripe. [px] and grey levels.
struct Candidate
{
  float v = 0.0F;           ///< where it is, to a pixel or better
  float sigma = 0.0F;       ///< 1-sigma half width down the column
  float height = 0.0F;      ///< of its top above the higher of its two feet
  float top = 0.0F;         ///< grey level of its top
  float brightness = 0.0F;  ///< height times width: what it weighs against the others in its column
};

/// The candidates of all columns, column after column: those of column u are [first[u], first[u + 1]).
struct CandidateList
{
  std::vector<Candidate> items;
  std::vector<int> first;
  std::vector<float> total_brightness;  ///< of each column, also of candidates that were too many to keep

  int size(int u) const { return first[static_cast<std::size_t>(u) + 1] - first[static_cast<std::size_t>(u)]; }
};

/// The candidate that was taken for the stripe in one column.
struct Seed
{
  int u = 0;
  float v = 0.0F;
  float sigma = 0.0F;  ///< 1-sigma half width down the column, evened out along the stripe [px]
  float brightness = 0.0F;
  bool starts_piece = false;  ///< the stripe is torn between the seed before and this one
  bool ambiguous = false;     ///< a second candidate in this column was nearly as good
};
}  // namespace weld_profiler
