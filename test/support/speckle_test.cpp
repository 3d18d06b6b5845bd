#include <gtest/gtest.h>

#include <cmath>

#include "support/speckle.h"

namespace
{
using weld_profiler::test_support::speckleIntensity;
using weld_profiler::test_support::SpeckleSettings;

TEST(Speckle, HasTheContrastAndTheGrainThatItIsToldToHave)
{
  const SpeckleSettings settings{ 400, 300, 0.2, 2.0 };
  std::mt19937 random(5);
  const std::vector<double> intensity = speckleIntensity(settings, random);
  ASSERT_EQ(intensity.size(), 120000U);
  double mean = 0.0, variance = 0.0, neighbours = 0.0, far = 0.0;
  for (const double value : intensity)
    mean += value / 120000.0;
  for (std::size_t i = 0; i + 10 < intensity.size(); ++i)
  {
    variance += std::pow(intensity[i] - mean, 2.0) / 120000.0;
    neighbours += (intensity[i] - mean) * (intensity[i + 1] - mean) / 120000.0;
    far += (intensity[i] - mean) * (intensity[i + 10] - mean) / 120000.0;
  }
  // 120000 pixels hold about 25000 grains: 1 % of the variance.
  EXPECT_NEAR(mean, 1.0, 0.01);
  EXPECT_NEAR(std::sqrt(variance), 0.2, 0.004);
  EXPECT_NEAR(neighbours / variance, 0.5, 0.03) << "half a full width at half maximum away";
  EXPECT_NEAR(far / variance, 0.0, 0.03);
}

TEST(Speckle, IsDarkAsOftenAsLightMakesItWhenFullyDeveloped)
{
  std::mt19937 random(6);
  const std::vector<double> intensity = speckleIntensity(SpeckleSettings{ 300, 300, 1.0, 2.0 }, random);
  std::size_t dark = 0;
  for (const double value : intensity)
    dark += value < 0.5 ? 1 : 0;
  // Negative exponential: P(I < 0.5) = 1 - exp(-0.5).
  EXPECT_NEAR(static_cast<double>(dark) / 90000.0, 1.0 - std::exp(-0.5), 0.01);
}
}  // namespace
