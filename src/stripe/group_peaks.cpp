#include "group_peaks.h"

#include <algorithm>

#include "multiversion.h"

namespace weld_profiler
{
namespace
{
constexpr int kLanes = 16;
constexpr float kTorn = 0.6F;  // a dip that stays above this share is speckle inside one stripe

typedef std::uint16_t Row __attribute__((vector_size(kLanes * sizeof(std::uint16_t))));

WELD_PROFILER_KERNEL void load(const std::uint16_t* from, Row& row)
{
  __builtin_memcpy(&row, from, sizeof(row));
}

struct Block
{
  const std::uint16_t* sums;  // 16 groups of the first row
  int first;                  // row
  std::size_t stride;
  int rows;
  int reach;  // rows to either side
  std::uint16_t least_height;
  GroupPeak* peaks;  // 16 x kMost
  int* counts;       // 16

  WELD_PROFILER_KERNEL const std::uint16_t* at(int row) const { return sums + static_cast<std::size_t>(row) * stride; }
};

WELD_PROFILER_KERNEL void keep(const Block& block, int lane, const GroupPeak& peak)
{
  GroupPeak* peaks = block.peaks + lane * GroupPeaks::kMost;
  int& count = block.counts[lane];
  if (count < GroupPeaks::kMost)
  {
    peaks[count++] = peak;
    return;
  }
  GroupPeak* weakest = std::min_element(peaks, peaks + count,
                                        [](const GroupPeak& a, const GroupPeak& b) { return a.height < b.height; });
  if (weakest->height >= peak.height)
    return;
  std::copy(weakest + 1, peaks + count, weakest);
  peaks[count - 1] = peak;
}

struct FindPeaks
{
  WELD_PROFILER_KERNEL static void run(Block block)
  {
    // Nearly all rows end at the first test: they do not rise above the darkest of their groups.
    Row floor;
    lowest(block, 0, block.rows, floor);
    floor = floor < static_cast<std::uint16_t>(65535 - block.least_height) ? floor + block.least_height : Row{} - 1;
    for (int i = 0; i < block.rows; ++i)
    {
      Row here;
      load(block.at(i), here);
      const Row risen = here > floor ? here : Row{};
      if (!isZero(risen))
        test(block, i, here);
    }
  }

  WELD_PROFILER_KERNEL static void test(const Block& block, int i, const Row& here)
  {
    Row before, after, left, right;
    load(block.at(i > 0 ? i - 1 : i), before);
    load(block.at(i + 1 < block.rows ? i + 1 : i), after);
    const Row above = i + 1 < block.rows ? (here > after ? here : Row{}) : Row{};
    const Row tops = here >= before ? above : Row{};
    if (isZero(tops))
      return;
    lowest(block, i > block.reach ? i - block.reach : 0, i > 0 ? i : 1, left);
    const int end = i + 1 + block.reach < block.rows ? i + 1 + block.reach : block.rows;
    lowest(block, i + 1 < end ? i + 1 : i, end, right);
    const Row base = left > right ? left : right;
    const Row height = here > base ? here - base : Row{};
    for (int k = 0; k < kLanes; ++k)
      if (tops[k] != 0 && height[k] > block.least_height)
        keep(block, k, GroupPeak{ static_cast<std::uint16_t>(block.first + i), here[k], height[k] });
  }

  /// Of each group, in rows [begin, end).
  WELD_PROFILER_KERNEL static void lowest(const Block& block, int begin, int end, Row& low)
  {
    load(block.at(begin), low);
    for (int i = begin + 1; i < end; ++i)
    {
      Row row;
      load(block.at(i), row);
      low = row < low ? row : low;
    }
  }

  WELD_PROFILER_KERNEL static bool isZero(const Row& row)
  {
    std::uint64_t words[kLanes / 4];
    __builtin_memcpy(words, &row, sizeof(words));
    return (words[0] | words[1] | words[2] | words[3]) == 0;
  }
};

/// The highest rise of 16 groups over their darkest, in every second row.
struct HighestRise
{
  WELD_PROFILER_KERNEL static void run(const std::uint16_t* sums, std::size_t stride, int rows, std::uint16_t* rise)
  {
    Row low, high;
    load(sums, low);
    high = low;
    for (int i = 2; i < rows; i += 2)
    {
      Row row;
      load(sums + static_cast<std::size_t>(i) * stride, row);
      low = row < low ? row : low;
      high = row > high ? row : high;
    }
    const Row rises = high - low;
    __builtin_memcpy(rise, &rises, sizeof(rises));
  }
};

bool risesWithin(const GroupSums& sums, float height, const RowRange& rows)
{
  const int first = rows.first + rows.first % 2;
  if (first >= rows.last)
    return false;
  for (std::size_t group = 0; group < sums.stride(); group += kLanes)
  {
    std::uint16_t rise[kLanes];
    dispatch<HighestRise>(sums.row(first) + group, sums.stride(), rows.last - first, static_cast<std::uint16_t*>(rise));
    for (int k = 0; k < kLanes && static_cast<int>(group) + k < sums.groups(); ++k)
      if (static_cast<float>(rise[k]) > height)
        return true;
  }
  return false;
}
}  // namespace

bool GroupPeaks::risesOutside(const GroupSums& sums, float height, const RowRange& rows)
{
  return risesWithin(sums, height, RowRange{ 0, rows.first }) ||
         risesWithin(sums, height, RowRange{ rows.last, sums.rows() });
}

void GroupPeaks::find(const GroupSums& sums, float least_height, const RowRange& rows)
{
  const int reach = std::max(1, kReach / sums.rowStep());
  peaks_.resize(sums.stride() * kMost);
  counts_.assign(sums.stride(), 0);
  for (std::size_t first = 0; first < sums.stride(); first += kLanes)
  {
    const auto least = static_cast<std::uint16_t>(std::clamp(least_height, 0.0F, 65534.0F));
    dispatch<FindPeaks>(Block{ sums.row(rows.first) + first, rows.first, sums.stride(), rows.last - rows.first, reach,
                               least, peaks_.data() + first * kMost, counts_.data() + first });
  }
  for (int group = 0; group < sums.groups(); ++group)
    if (counts_[static_cast<std::size_t>(group)] > 1)
      mergeTorn(sums, group);
}

/// Speckle tears the top of a wide stripe: neighbours that share a high dip are one.
void GroupPeaks::mergeTorn(const GroupSums& sums, int group)
{
  GroupPeak* peaks = peaks_.data() + static_cast<std::size_t>(group) * kMost;
  int& count = counts_[static_cast<std::size_t>(group)];
  const int near = 2 * kReach / sums.rowStep();
  int kept = 0;
  for (int i = 1; i < count; ++i)
  {
    GroupPeak& before = peaks[kept];
    const GroupPeak& next = peaks[i];
    bool torn = next.row - before.row <= near;
    if (torn)
    {
      int dip = next.top;
      for (int row = before.row; row < next.row; ++row)
        dip = std::min<int>(dip, sums.row(row)[group]);
      const int base = std::min(before.top - before.height, next.top - next.height);
      torn = static_cast<float>(dip - base) > kTorn * static_cast<float>(std::min(before.top, next.top) - base);
    }
    if (!torn)
      peaks[++kept] = next;
    else if (next.top > before.top)
      before = GroupPeak{ next.row, next.top, std::max(before.height, next.height) };
  }
  count = kept + 1;
}
}  // namespace weld_profiler
