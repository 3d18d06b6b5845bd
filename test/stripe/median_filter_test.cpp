#include "stripe/median_filter.h"

#include <gtest/gtest.h>

#include <random>

#include "support/render_stripe.h"

namespace weld_profiler
{
namespace
{
using test_support::Picture;

Picture noise(int width, int height, int bit_depth)
{
  std::mt19937 random(3);
  Picture picture = test_support::blank(width, height, 0.0, bit_depth);
  std::uniform_real_distribution<double> level(0.0, bit_depth == 8 ? 255.0 : 65535.0);
  for (int v = 0; v < height; ++v)
    for (int u = 0; u < width; ++u)
      picture.set(u, v, level(random));
  return picture;
}

double bruteForceMedian(const Picture& picture, int u, int v, int size)
{
  std::vector<double> values;
  for (int j = -size / 2; j <= size / 2; ++j)
    for (int i = -size / 2; i <= size / 2; ++i)
      values.push_back(picture.at(std::clamp(u + i, 0, picture.width - 1), std::clamp(v + j, 0, picture.height - 1)));
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

double level(const ImageView& view, int u, int v)
{
  return view.bit_depth == 8 ? view.row<std::uint8_t>(v)[u] : view.row<std::uint16_t>(v)[u];
}

class MedianFilter : public ::testing::TestWithParam<std::tuple<int, int>>
{
};

TEST_P(MedianFilter, IsTheMedianOfEachNeighbourhood)
{
  const auto [size, bit_depth] = GetParam();
  const Picture picture = noise(151, 37, bit_depth);
  std::vector<std::uint8_t> memory;
  ImageView whole;
  medianFilter(picture.view(), size, memory, whole);
  ASSERT_EQ(whole.width, picture.width);
  ASSERT_EQ(whole.height, picture.height);
  for (int v = 0; v < picture.height; ++v)
    for (int u = 0; u < picture.width; ++u)
      ASSERT_EQ(level(whole, u, v), bruteForceMedian(picture, u, v, size)) << u << ", " << v;
}

INSTANTIATE_TEST_SUITE_P(SizesAndDepths, MedianFilter,
                         ::testing::Combine(::testing::Values(3, 5), ::testing::Values(8, 16)));

TEST(MedianFilter, OfSizeZeroCopies)
{
  const Picture picture = noise(20, 20, 8);
  std::vector<std::uint8_t> memory;
  ImageView whole;
  medianFilter(picture.view(), 0, memory, whole);
  for (int v = 0; v < picture.height; ++v)
    for (int u = 0; u < picture.width; ++u)
      ASSERT_EQ(level(whole, u, v), picture.at(u, v));
}
}  // namespace
}  // namespace weld_profiler
