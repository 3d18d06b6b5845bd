#include "weld/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

using weld_profiler::weld::median;
using weld_profiler::weld::selectInPlace;

namespace
{
double sortedMedian(std::vector<double> values)
{
  values.erase(std::remove_if(values.begin(), values.end(), [](double value) { return !std::isfinite(value); }),
               values.end());
  if (values.empty())
    return std::nan("");
  std::sort(values.begin(), values.end());
  return 0.5 * (values[(values.size() - 1) / 2] + values[values.size() / 2]);
}

/// Values of a few levels, so that equal ones meet, and of noise; ordered and not.
std::vector<std::vector<double>> samplesOf(std::size_t size)
{
  std::mt19937 random(static_cast<unsigned>(size));
  std::uniform_int_distribution<int> level(-3, 3);
  std::normal_distribution<double> noise;
  std::vector<std::vector<double>> samples(5, std::vector<double>(size));
  for (std::size_t i = 0; i < size; ++i)
  {
    samples[0][i] = noise(random);
    samples[1][i] = level(random);
    samples[2][i] = static_cast<double>(i) * (i % 2 == 0 ? 1.0 : -1.0);
    samples[3][i] = 7.0;
    samples[4][i] = static_cast<double>(size - i);
  }
  return samples;
}
}  // namespace

TEST(Statistics, MedianIsThatOfSortedValuesForEveryNumberOfThem)
{
  for (std::size_t size = 1; size <= 400; ++size)
    for (const std::vector<double>& values : samplesOf(size))
      ASSERT_EQ(sortedMedian(values), median(values)) << size << " values";
}

TEST(Statistics, MedianLeavesOutWhatIsNotFinite)
{
  for (std::vector<double> values : samplesOf(101))
  {
    for (std::size_t i = 0; i < values.size(); i += 3)
      values[i] = i % 2 == 0 ? std::nan("") : std::numeric_limits<double>::infinity();
    ASSERT_EQ(sortedMedian(values), median(values));
  }
  EXPECT_TRUE(std::isnan(median({ std::nan(""), std::nan("") })));
  EXPECT_TRUE(std::isnan(median({})));
}

TEST(Statistics, SelectingPutsEachRankInItsPlace)
{
  for (const std::vector<double>& values : samplesOf(97))
    for (std::size_t rank = 0; rank < values.size(); ++rank)
    {
      std::vector<double> sorted = values, selected = values;
      std::sort(sorted.begin(), sorted.end());
      selectInPlace(selected.data(), selected.data() + rank, selected.data() + selected.size());
      ASSERT_EQ(sorted[rank], selected[rank]);
      const auto nth = selected.begin() + static_cast<std::ptrdiff_t>(rank);
      ASSERT_LE(*std::max_element(selected.begin(), nth + 1), *nth);
      ASSERT_GE(*std::min_element(nth, selected.end()), *nth);
    }
}
