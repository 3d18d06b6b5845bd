#pragma once

#include <cstddef>
#include <vector>

#include "centre.h"

namespace weld_profiler
{
/// What the centres scatter about their own line beyond Centre::read_sigma (shot noise, speckle), from differences
/// along the line in blocks of 64 cells. 1-sigma down the column, one value a centre. [px]
///
/// A block that holds too few differences takes the value of the nearest one that does. A stripe too short for any of
/// them is judged by the scatter of its column centroids, whose neighbours are independent, brought to the method by
/// the ratio of the noise both pass on; one that is too short for that too is given a share of its width.
class LineScatter
{
public:
  void measure(const std::vector<Centre>& centres);
  double operator[](std::size_t i) const { return excess_[i]; }

private:
  struct Differences;

  void place(const std::vector<Centre>& centres);
  bool measureBlocks(const std::vector<Centre>& centres);
  double ofAShortStripe(const std::vector<Centre>& centres);
  void collect(const Differences& rule, int first, int last);
  double scatter(const Differences& rule);

  // one a cell, counted from the first centre's
  std::vector<int> piece_;           ///< that its centre belongs to, counted from 0; kNone = no centre
  std::vector<double> row_;          ///< at which the line crosses the middle of the cell
  std::vector<double> initial_row_;  ///< where the centroid put it
  std::vector<double> variance_;     ///< that the background's noise explains; 0 = no centre

  std::vector<double> excess_;  ///< one a centre
  std::vector<double> blocks_;
  std::vector<double> differences_;
};
}  // namespace weld_profiler
