#pragma once

#include <cstdint>
#include <string>

namespace weld_profiler
{
/// One cloud of a data set.
struct DatasetEntry
{
  std::string file;              ///< below the data set's folder: train/weld_000000.pcd
  std::string split;             ///< train, validation
  std::uint64_t scene_seed = 0;  ///< of randomWeldScene
};

/// Which clouds a data set has. Neither depends on how many there are, so that a data set can grow.
struct DatasetPlan
{
  std::uint64_t seed = 0;
  double validation = 0.2;  ///< share of the first N, whatever N, and of each kind, 0..0.9

  DatasetEntry entry(int index) const;

private:
  int heldOutOf(int count) const;  ///< how many of the first
  bool holdsOut(int index) const;
  int kindOf(int index) const;
};
}  // namespace weld_profiler
