#include "stripe/otsu.h"

#include <gtest/gtest.h>

#include <random>

namespace weld_profiler
{
namespace
{
/// The definition, pixel by pixel: the threshold whose two classes have the largest variance between them.
int bruteForce(const std::vector<int>& pixels)
{
  int best = 0;
  double largest = 0.0;
  for (int threshold = 0; threshold < kBins; ++threshold)
  {
    double count[2] = { 0.0, 0.0 };
    double sum[2] = { 0.0, 0.0 };
    for (const int pixel : pixels)
    {
      const int side = pixel > threshold ? 1 : 0;
      count[side] += 1.0;
      sum[side] += pixel;
    }
    if (count[0] == 0.0 || count[1] == 0.0)
      continue;
    const double difference = sum[0] / count[0] - sum[1] / count[1];
    const double between = count[0] * count[1] * difference * difference;
    if (between > largest * (1.0 + 1e-12))
    {
      largest = between;
      best = threshold;
    }
  }
  return best;
}

TEST(Otsu, AgreesWithTheDefinitionOnRandomImages)
{
  std::mt19937 random(7);
  for (int trial = 0; trial < 20; ++trial)
  {
    std::normal_distribution<double> dark(10.0 + 3.0 * trial, 5.0);
    std::normal_distribution<double> bright(120.0 + 4.0 * trial, 25.0);
    std::vector<int> pixels;
    Histogram histogram{};
    for (int i = 0; i < 600; ++i)
    {
      const double value = i % (5 + trial) == 0 ? bright(random) : dark(random);
      pixels.push_back(std::clamp(static_cast<int>(value), 0, kBins - 1));
      ++histogram[static_cast<std::size_t>(pixels.back())];
    }
    EXPECT_EQ(otsuBin(histogram), bruteForce(pixels)) << "trial " << trial;
  }
}

TEST(Otsu, OfAnImageOfOneLevelIsZero)
{
  Histogram histogram{};
  EXPECT_EQ(otsuBin(histogram), 0);
  histogram[42] = 1000;
  EXPECT_EQ(otsuBin(histogram), 0);
}
}  // namespace
}  // namespace weld_profiler
