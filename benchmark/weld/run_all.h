#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "weld/weld_case.h"

namespace weld_profiler
{
namespace weld_accuracy
{
/// Which welds, and how.
struct Selection
{
  int welds = 200;
  std::uint64_t first = 0;  ///< seed of the first; the others follow it
  int threads = 1;          ///< 1..2
  std::string state;        ///< folder of the welds already measured; empty = none is kept
};

/// Told after each weld.
using Progress = std::function<void(const WeldCase& weld, int done)>;

/// All welds, rising seeds; those of the state folder are read, the others measured and left there.
/// @throws InputError when the folder cannot be written; the first thing that a weld throws.
std::vector<WeldCase> runAll(const Selection& run, const Progress& progress);
}  // namespace weld_accuracy
}  // namespace weld_profiler
