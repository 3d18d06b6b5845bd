#include "group_peaks.h"

#include <algorithm>
#include <cstring>

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
  const std::uint16_t* sums;  // first row of 16 groups
  std::size_t stride;
  int rows;
  int reach;  // rows to either side
  std::uint16_t least_height;
  std::uint16_t* padded;  // (rows + 2 reach) x 16
  std::uint16_t* lowest;  // the same size
  GroupPeak* peaks;       // 16 x kMost
  int* counts;            // 16
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
    pad(block);
    const int length = lowestOf(block);
    const Row least = Row{} + block.least_height;
    for (int i = 0; i < block.rows; ++i)
    {
      const std::uint16_t* at = block.padded + (i + block.reach) * kLanes;
      // The windows of `reach` rows on either side, each as two that overlap.
      const std::uint16_t* low = block.lowest + (i + block.reach) * kLanes;
      Row before, here, after, left_a, left_b, right_a, right_b;
      load(at - kLanes, before);
      load(at, here);
      load(at + kLanes, after);
      load(low - kLanes, left_a);
      load(low + (length - 1 - block.reach) * kLanes, left_b);
      load(low + length * kLanes, right_a);
      load(low + block.reach * kLanes, right_b);
      const Row left = left_a < left_b ? left_a : left_b;
      const Row right = right_a < right_b ? right_a : right_b;
      const Row base = left > right ? left : right;
      const Row height = here > base ? here - base : Row{};
      const Row tops = (here >= before) & (here > after) & (height > least) ? height : Row{};
      if (isZero(tops))
        continue;
      for (int k = 0; k < kLanes; ++k)
        if (tops[k] != 0)
          keep(block, k, GroupPeak{ static_cast<std::uint16_t>(i), here[k], tops[k] });
    }
  }

  WELD_PROFILER_KERNEL static bool isZero(const Row& row)
  {
    std::uint64_t words[kLanes / 4];
    __builtin_memcpy(words, &row, sizeof(words));
    return (words[0] | words[1] | words[2] | words[3]) == 0;
  }

  WELD_PROFILER_KERNEL static void pad(const Block& block)
  {
    std::uint16_t* to = block.padded;
    const auto copy = [&](int row)
    {
      std::memcpy(to, block.sums + static_cast<std::size_t>(row) * block.stride, kLanes * sizeof(*to));
      to += kLanes;
    };
    for (int i = 0; i < block.reach; ++i)
      copy(0);
    for (int i = 0; i < block.rows; ++i)
      copy(i);
    for (int i = 0; i < block.reach; ++i)
      copy(block.rows - 1);
  }

  /// Running minimum over the largest power of two of rows that fits the reach, ending at each row. Returns its length.
  WELD_PROFILER_KERNEL static int lowestOf(const Block& block)
  {
    const int total = (block.rows + 2 * block.reach) * kLanes;
    std::memcpy(block.lowest, block.padded, static_cast<std::size_t>(total) * sizeof(std::uint16_t));
    int length = 1;
    for (; 2 * length <= block.reach; length *= 2)
    {
      const int lag = length * kLanes;
      for (int i = total - kLanes; i >= lag; i -= kLanes)
      {
        Row here, before;
        load(block.lowest + i, here);
        load(block.lowest + i - lag, before);
        const Row low = here < before ? here : before;
        __builtin_memcpy(block.lowest + i, &low, sizeof(low));
      }
    }
    return length;
  }
};
}  // namespace

void GroupPeaks::find(const GroupSums& sums, float least_height)
{
  const int reach = std::max(1, kReach / sums.rowStep());
  const std::size_t size = static_cast<std::size_t>(sums.rows() + 2 * reach) * kLanes;
  block_.resize(size);
  lowest_.resize(size);
  peaks_.resize(sums.stride() * kMost);
  counts_.assign(sums.stride(), 0);
  for (std::size_t first = 0; first < sums.stride(); first += kLanes)
  {
    const auto least = static_cast<std::uint16_t>(std::clamp(least_height, 0.0F, 65534.0F));
    dispatch<FindPeaks>(Block{ sums.row(0) + first, sums.stride(), sums.rows(), reach, least, block_.data(),
                               lowest_.data(), peaks_.data() + first * kMost, counts_.data() + first });
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
