#pragma once

#include <cstdint>
#include <vector>

namespace weld_profiler
{
namespace weld
{
/// Heights of the sections of a weld in bins across it: those of section k begin at k * columns.
struct SectionStack
{
  const std::vector<double>& places;       ///< of the sections, rising [m]
  std::vector<float>& heights;             ///< NaN = not seen [m]
  const std::vector<std::uint8_t>& known;  ///< of the sections, whether they show the whole bead
  std::size_t columns = 0;                 ///< bins
  std::size_t first = 0, last = 0;         ///< bins of the face
  double bin = 0.0;                        ///< width [m]
};

/// Takes the hollows of the face out of a stack (NaN): places lower than before and behind them along the weld, and by
/// more than the rest of their section is; between 1 and 4 mm wide. They drag along the median of the sections beside
/// them, however shallow they are.
/// @return  of each height whether it was taken out; empty = none was.
std::vector<std::uint8_t> takeOutHollows(const SectionStack& stack);
}  // namespace weld
}  // namespace weld_profiler
