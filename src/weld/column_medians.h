#pragma once

#include <cstddef>
#include <vector>

namespace weld_profiler
{
namespace weld
{
constexpr std::size_t kMostMedianRows = 16;

/// Median of what is finite in each column of a few rows; NaN where nothing is. Many columns at once are put in order
/// by the same exchanges (Batcher's odd-even merge sort, 1968), which a processor does in step.
/// @param rows     first elements of at most kMostMedianRows rows.
/// @param columns  elements of a row.
/// @param medians  filled, one a column.
void columnMedians(const std::vector<const float*>& rows, std::size_t columns, std::vector<double>& medians);
}  // namespace weld
}  // namespace weld_profiler
