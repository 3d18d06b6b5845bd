#include "tools/dataset_plan.h"

#include <cmath>
#include <cstdio>

namespace weld_profiler
{
namespace
{
constexpr int kKinds = 3;  // a weld of each in every turn; randomWeldScene takes the kind from the seed

/// SplitMix64's finaliser (Steele et al. 2014).
std::uint64_t mixed(std::uint64_t value)
{
  value += 0x9E3779B97F4A7C15ULL;
  value = (value ^ (value >> 30)) * 0xBF58476D1CE4E5B9ULL;
  value = (value ^ (value >> 27)) * 0x94D049BB133111EBULL;
  return value ^ (value >> 31);
}
}  // namespace

/// Every 1/validation-th of all, from a place that the seed chooses.
int DatasetPlan::heldOutOf(int count) const
{
  const double phase = static_cast<double>(mixed(seed) >> 11) / 9007199254740992.0;
  return static_cast<int>(std::floor(phase + count * validation));
}

bool DatasetPlan::holdsOut(int index) const
{
  return heldOutOf(index + 1) > heldOutOf(index);
}

/// Those held out are dealt to the kinds in rotation, the others of the turn to the kinds that are left.
int DatasetPlan::kindOf(int index) const
{
  const int begin = index / kKinds * kKinds;
  const int held_out_in_turn = heldOutOf(begin + kKinds) - heldOutOf(begin);
  int place = holdsOut(index) ? 0 : held_out_in_turn;
  for (int i = begin; i < index; ++i)
    place += holdsOut(i) == holdsOut(index) ? 1 : 0;
  return (heldOutOf(begin) + place) % kKinds;
}

DatasetEntry DatasetPlan::entry(int index) const
{
  const std::uint64_t stream = mixed(mixed(seed) ^ static_cast<std::uint64_t>(index / kKinds)) >> 2;
  DatasetEntry entry;
  entry.split = holdsOut(index) ? "validation" : "train";
  entry.scene_seed = stream / kKinds * kKinds + static_cast<std::uint64_t>(kindOf(index));
  char name[32];
  std::snprintf(name, sizeof name, "/weld_%06d.pcd", index);
  entry.file = entry.split + name;
  return entry;
}
}  // namespace weld_profiler
