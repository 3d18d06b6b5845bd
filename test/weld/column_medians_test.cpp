#include "weld/column_medians.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

using weld_profiler::weld::columnMedians;
using weld_profiler::weld::kMostMedianRows;

namespace
{
constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

double sortedMedian(const std::vector<std::vector<float>>& rows, std::size_t column)
{
  std::vector<double> values;
  for (const std::vector<float>& row : rows)
    if (std::isfinite(row[column]))
      values.push_back(static_cast<double>(row[column]));
  if (values.empty())
    return std::nan("");
  std::sort(values.begin(), values.end());
  return 0.5 * (values[(values.size() - 1) / 2] + values[values.size() / 2]);
}
}  // namespace

TEST(ColumnMedians, AreThoseOfSortedColumnsForEveryNumberOfRows)
{
  std::mt19937 random(7);
  std::uniform_int_distribution<int> level(-20, 20);  // few levels: equal values meet
  std::uniform_int_distribution<int> hole(0, 3);
  for (std::size_t count = 0; count <= kMostMedianRows; ++count)
  {
    const std::size_t columns = 150 + count;  // blocks of columns end anywhere
    std::vector<std::vector<float>> rows(count, std::vector<float>(columns));
    std::vector<const float*> starts;
    for (std::vector<float>& row : rows)
    {
      for (float& value : row)
        value = hole(random) == 0 ? kNone : 1e-5F * static_cast<float>(level(random));
      starts.push_back(row.data());
    }
    std::vector<double> medians;
    columnMedians(starts, columns, medians);
    ASSERT_EQ(columns, medians.size());
    for (std::size_t column = 0; column < columns; ++column)
    {
      const double expected = sortedMedian(rows, column);
      ASSERT_EQ(std::isnan(expected), std::isnan(medians[column])) << count << " rows, column " << column;
      if (std::isnan(expected))
        continue;
      ASSERT_EQ(expected, medians[column]) << count << " rows, column " << column;
    }
  }
}
