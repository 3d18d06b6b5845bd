#pragma once

#include <cstdint>
#include <vector>

#include "group_sums.h"

namespace weld_profiler
{
/// A rise in one group of columns that could be the stripe. Rows and heights are those of GroupSums.
struct GroupPeak
{
  std::uint16_t row = 0;     ///< of its top
  std::uint16_t top = 0;     ///< the sum there
  std::uint16_t height = 0;  ///< above the higher of what lies 48 px to either side
};

/// Rows of GroupSums, [first, last).
struct RowRange
{
  int first = 0, last = 0;
};

/// Finds in every group the tops that stand out of their own surroundings, whatever light lies under them.
///
/// A top must rise above the lowest of the 48 rows on either side: a stripe of up to 12 px of half width does, a glow
/// or the edge of a bright part does not. Tops torn by speckle are one.
class GroupPeaks
{
public:
  static constexpr int kMost = 8;    ///< tops kept a group, the highest
  static constexpr int kReach = 48;  ///< rows looked at on either side [px]

  /// @param least_height  that counts, in units of the sums.
  /// @param rows          that are searched; the others need not be summed.
  void find(const GroupSums& sums, float least_height, const RowRange& rows);

  /// Whether one of the even rows outside holds something that rises so high above the darkest of them.
  static bool risesOutside(const GroupSums& sums, float height, const RowRange& rows);

  int size(int group) const { return counts_[static_cast<std::size_t>(group)]; }
  const GroupPeak& at(int group, int i) const { return peaks_[static_cast<std::size_t>(group * kMost + i)]; }

private:
  void mergeTorn(const GroupSums& sums, int group);

  std::vector<GroupPeak> peaks_;
  std::vector<int> counts_;
};
}  // namespace weld_profiler
