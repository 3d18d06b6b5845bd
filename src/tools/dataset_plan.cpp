#include "tools/dataset_plan.h"

#include <cmath>
#include <cstdio>

namespace weld_profiler
{
namespace
{
constexpr int kKinds = 3;  // randomWeldScene's kinds take turns, seed by seed

/// SplitMix64's finaliser (Steele et al. 2014).
std::uint64_t mixed(std::uint64_t value)
{
  value += 0x9E3779B97F4A7C15ULL;
  value = (value ^ (value >> 30)) * 0xBF58476D1CE4E5B9ULL;
  value = (value ^ (value >> 27)) * 0x94D049BB133111EBULL;
  return value ^ (value >> 31);
}
}  // namespace

DatasetEntry DatasetPlan::entry(int index) const
{
  const int turn = index / kKinds;
  // of each kind every 1/validation-th goes to validation, from a place that the seed chooses
  const double phase = static_cast<double>(mixed(seed) >> 11) / 9007199254740992.0;
  const bool held_out = std::floor(phase + (turn + 1) * validation) > std::floor(phase + turn * validation);
  const std::uint64_t stream = mixed(mixed(seed) ^ static_cast<std::uint64_t>(turn)) >> 2;
  DatasetEntry entry;
  entry.split = held_out ? "validation" : "train";
  entry.scene_seed = stream / kKinds * kKinds + static_cast<std::uint64_t>(index % kKinds);
  char name[32];
  std::snprintf(name, sizeof name, "/weld_%06d.pcd", index);
  entry.file = entry.split + name;
  return entry;
}
}  // namespace weld_profiler
