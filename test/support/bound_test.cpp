// The Cramer-Rao bounds that benchmark/stripe_comparison holds errors against.
#include <gtest/gtest.h>

#include <cmath>

#include "comparison/bound.h"

namespace
{
using weld_profiler::comparison::Bound;
using weld_profiler::comparison::BoundSettings;

const double kPi = std::acos(-1.0);

/// The information of one column, half read and half shot noise and rounding, by quadrature.
double columnByQuadrature(const BoundSettings& settings)
{
  const double variance = std::pow(settings.peak / settings.snr, 2.0);
  double information = 0.0;
  constexpr double kStep = 1e-3;
  for (double y = -40.0; y < 40.0; y += kStep)
  {
    const double light = std::exp(-0.5 * y * y / (settings.sigma * settings.sigma));
    const double change = settings.peak * light * y / (settings.sigma * settings.sigma);
    information += kStep * change * change / (0.5 * variance * (1.0 + light) + 1.0 / 12.0);
  }
  return 1.0 / std::sqrt(information);
}

TEST(Bound, OfOneColumnIsTheIntegralOfTheSquaredSlopeOverTheNoise)
{
  for (const double sigma : { 1.5, 2.0, 5.0 })
  {
    BoundSettings settings;
    settings.sigma = sigma;
    settings.background = 32.0;
    settings.peak = 180.0;
    // A sum over pixels is the integral to 1e-4 from sigma 1 px on; the shot noise's own information is 1e-3.
    EXPECT_NEAR(Bound(settings).ofColumns(1) / columnByQuadrature(settings), 1.0, 2e-3) << "sigma " << sigma;
  }
}

TEST(Bound, LiesBetweenTheClosedFormsOfTheLeastAndTheLargestNoise)
{
  // Uniform noise s: bound^2 = 2 sigma s^2 / (peak^2 sqrt(pi)). Here s^2 goes from half to all of (peak / SNR)^2.
  BoundSettings settings;
  settings.background = 32.0;
  settings.peak = 180.0;
  settings.snr = 20.0;  // the rounding to grey levels does not count beside
  const double all = std::sqrt(2.0 * settings.sigma / std::sqrt(kPi)) / settings.snr;
  EXPECT_LT(Bound(settings).ofColumns(1), all);
  EXPECT_GT(Bound(settings).ofColumns(1), all / std::sqrt(2.0));
}

TEST(Bound, FallsWithTheRootOfTheColumnsOfALevelStripe)
{
  const Bound bound({});
  for (const int columns : { 3, 9, 25 })
    EXPECT_NEAR(bound.ofColumns(columns) * std::sqrt(columns) / bound.ofColumns(1), 1.0, 1e-6) << columns;
}

TEST(Bound, OfOneColumnFallsWithTheRootOfTheCosineOfTheSlope)
{
  BoundSettings steep;
  steep.slope = std::tan(60.0 * kPi / 180.0);
  EXPECT_NEAR(Bound(steep).ofColumns(1) / Bound({}).ofColumns(1), std::sqrt(0.5), 1e-3);
}

TEST(Bound, LosesNothingToTheUnknownSlopeWhereColumnsLieEvenlyAboutThePoint)
{
  BoundSettings steep;
  steep.slope = 1.0;
  EXPECT_NEAR(Bound(steep).ofColumns(3) * std::sqrt(3.0) / Bound(steep).ofColumns(1), 1.0, 5e-3);
}

TEST(Bound, CountsRoundingAsATwelfthOfASquaredGreyLevel)
{
  BoundSettings settings;
  settings.background = 32.0;
  settings.peak = 100.0;
  settings.snr = 50.0;  // 1.41 DN without light
  EXPECT_NEAR(Bound(settings).pixelInformation(0.0) * (2.0 + 1.0 / 12.0), 1.0, 2e-3);
}

TEST(Bound, TellsNothingOfAPixelFarBeyondFullScale)
{
  BoundSettings settings;
  settings.peak = 1000.0;
  settings.snr = 200.0;
  const Bound bound(settings);
  EXPECT_LT(bound.pixelInformation(900.0), 1e-9);
  EXPECT_GT(bound.pixelInformation(150.0), 0.01);
}
}  // namespace
