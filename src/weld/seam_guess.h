#pragma once

#include <vector>

#include "bead_tracks.h"
#include "parent_fit.h"
#include "weld_path.h"

namespace weld_profiler
{
namespace weld
{
/// What the rows tell of a section before it is cut: where its toes and parents are, roughly.
class SeamGuess
{
public:
  SeamGuess(const ScanGrid& grid, const BeadTrack& track, const WeldPath& path);

  /// q of the toe near s, the median of a few rows.
  double toe(Side side, double s) const;

  /// The parent line of a section, from the lines of the rows that it crosses; invalid where the rows show none.
  Line parent(Side side, const WeldPathPoint& place, double toe) const;

private:
  struct Toe
  {
    double s, q;
  };
  double parentHeight(Side side, const WeldPathPoint& place, double q) const;

  const ScanGrid& grid_;
  const BeadTrack& track_;
  std::vector<Toe> left_, right_;
  std::vector<std::size_t> nearest_;  ///< of each grid row, the track's row nearest to it
};
}  // namespace weld
}  // namespace weld_profiler
