// gauss_fit, fir_peak, log_parabola: what each does that the centroids don't.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "stripe/gauss_model.h"
#include "support/extract.h"

namespace weld_profiler
{
namespace
{
using test_support::extract;
using test_support::paramsOf;
using test_support::render;
using test_support::straight;
using test_support::StripePicture;

struct Error
{
  double rmse_mpx = 0.0, in_sigmas = 0.0, width = 0.0;
  std::size_t count = 0;
};

Error measure(const StripeParams& params, StripePicture scene)
{
  Error error;
  scene.width = 600;
  const Stripe stripe = extract(params, render(scene));
  error.count = stripe.size();
  for (std::size_t i = 0; i < stripe.size(); ++i)
  {
    const double e = distanceAcross(scene, stripe.u[i], stripe.v[i]);
    error.rmse_mpx += 1e6 * e * e / static_cast<double>(stripe.size());
    error.in_sigmas += std::pow(e / stripe.sigma[i], 2.0) / static_cast<double>(stripe.size());
    error.width += stripe.width[i] / static_cast<double>(stripe.size());
  }
  error.rmse_mpx = std::sqrt(error.rmse_mpx);
  error.in_sigmas = std::sqrt(error.in_sigmas);
  return error;
}

/// Peak noise of 4 levels, whatever the peak.
StripePicture clippedScene(double peak)
{
  StripePicture scene = straight(3.17, 40.0);
  scene.peak = peak;
  scene.snr = peak / 4.0;
  return scene;
}

TEST(GaussFit, MeasuresClippedStripesByTheirFlanks)
{
  for (const char* fit : { "maximum_likelihood", "least_squares" })
    for (const double peak : { 300.0, 600.0, 1000.0 })
    {
      StripeParams params = paramsOf("gauss_fit");
      params.fit = fit;
      const Error error = measure(params, clippedScene(peak));
      ASSERT_EQ(error.count, 600U);
      // 19, 15 and 15 mpx were measured; the centroid's are 22, 37 and 50.
      EXPECT_LE(error.rmse_mpx, peak < 500.0 ? 22.0 : 18.0) << fit << ", peak " << peak;
      EXPECT_NEAR(error.in_sigmas, 1.0, 0.2) << fit << ", peak " << peak;
      EXPECT_NEAR(error.width, 2.0, 0.05) << "the width of the light, not of the flat top";
    }
}

TEST(GaussFit, HasAnHonestSigmaFromNarrowToWide)
{
  for (const double sigma : { 0.8, 1.5, 3.0, 5.0 })
    for (const double snr : { 20.0, 100.0 })
    {
      StripePicture scene = straight(10.17, 40.0);
      scene.height = 220;
      scene.sigma = sigma;
      scene.snr = snr;
      const Error error = measure(paramsOf("gauss_fit"), scene);
      ASSERT_EQ(error.count, 600U);
      EXPECT_GE(error.in_sigmas, 0.8) << "sigma " << sigma << ", SNR " << snr;
      EXPECT_LE(error.in_sigmas, 1.25) << "sigma " << sigma << ", SNR " << snr;
    }
}

/// A column of 21 rows in which shot noise rules.
GrayColumn shotColumn(std::mt19937& random, const GaussModel& model, const PixelNoise& noise)
{
  std::normal_distribution<double> normal;
  GrayColumn column;
  for (int v = 0; v < 21; ++v)
  {
    const double light = model.amplitude * std::exp(-0.5 * std::pow((v - model.centre) / model.sigma, 2.0));
    column.gray.push_back(light + normal(random) * std::sqrt(noise.read * noise.read + noise.gain * light));
  }
  column.clipped.assign(column.gray.size(), 0);
  return column;
}

TEST(GaussFit, GainsFromKnowingTheNoiseWhereShotNoiseRules)
{
  std::mt19937 random(3);
  const PixelNoise noise{ 0.5, 1.0 };
  double likely = 0.0, least = 0.0, gain = 0.0;
  constexpr int kColumns = 2000;
  for (int i = 0; i < kColumns; ++i)
  {
    const GaussModel truth{ 200.0, 10.0 + 0.5 * std::sin(i), 2.5, 0.0 };
    const GrayColumn column = shotColumn(random, truth, noise);
    const GaussModel start{ 180.0, 10.0, 3.0, 0.0 };
    const GaussFit by_likelihood = fitGauss(column, noise, start);
    const GaussFit by_squares = fitGauss(column, PixelNoise{ 0.5, 0.0 }, start);
    ASSERT_TRUE(by_likelihood.settled && by_squares.settled) << "column " << i;
    likely += std::pow(by_likelihood.model.centre - truth.centre, 2.0) / kColumns;
    least += std::pow(by_squares.model.centre - truth.centre, 2.0) / kColumns;
    gain += gainOf(column, by_squares.model, noise.read) / kColumns;
  }
  // The Cramer-Rao bounds of these columns, from the inverse of the information matrix, are 70.3 and 87.7 mpx; 2000
  // columns tell them to 1.6 %.
  EXPECT_NEAR(1000.0 * std::sqrt(likely), 70.3, 3.5);
  EXPECT_NEAR(1000.0 * std::sqrt(least), 87.7, 4.4);
  EXPECT_NEAR(gain, 0.8, 0.1) << "a fit takes more of the top's noise than of the flanks', where there is none";
}

TEST(GaussFit, LeavesAColumnThatIsNoGaussianUnsettledOrWhereItWas)
{
  GrayColumn column;
  column.gray.assign(15, 0.0);
  column.clipped.assign(15, 0);
  EXPECT_FALSE(fitGauss(column, PixelNoise{ 1.0, 0.0 }, GaussModel{ 50.0, 7.0, 2.0, 0.0 }).settled) << "nothing";
  column.gray.assign(4, 100.0);
  column.clipped.assign(4, 0);
  EXPECT_FALSE(fitGauss(column, PixelNoise{ 1.0, 0.0 }, GaussModel{ 50.0, 2.0, 2.0, 0.0 }).settled) << "too few rows";
  column.gray.assign(15, 100.0);
  column.clipped.assign(15, 1);
  EXPECT_FALSE(fitGauss(column, PixelNoise{ 1.0, 0.0 }, GaussModel{ 100.0, 7.0, 4.0, 0.0 }).settled) << "all clipped";
}

TEST(FirPeak, DoesNotMindABackgroundThatRises)
{
  StripePicture scene = straight(3.17, 60.0);
  scene.height = 160;
  scene.peak = 120.0;
  scene.ambient = [](double, double v) { return 0.5 * v; };
  const Error error = measure(paramsOf("fir_peak"), scene);
  ASSERT_EQ(error.count, 600U);
  // A slope of 0.5 levels a row alone would pull it by 0.5 * sigma^2 / peak * 2.8 = 47 mpx; rounding leaves 5.
  EXPECT_LE(error.rmse_mpx, 10.0);
}

TEST(FirPeak, TellsWhatTheStraightLineBetweenTwoSamplesCosts)
{
  for (const double sigma : { 0.8, 1.0, 2.0 })
  {
    StripePicture scene = straight(3.17, 40.0);
    scene.sigma = sigma;
    const Error error = measure(paramsOf("fir_peak"), scene);
    ASSERT_EQ(error.count, 600U);
    EXPECT_LE(error.rmse_mpx, 34.5 / (sigma * sigma + std::max(1.0, sigma * sigma)) + 3.0) << "sigma " << sigma;
    EXPECT_GE(error.in_sigmas, 0.5) << "sigma " << sigma;
    EXPECT_LE(error.in_sigmas, 1.25) << "sigma " << sigma;
  }
}

TEST(LogParabola, IsExactForAGaussian)
{
  for (const double sigma : { 1.2, 2.0, 3.0 })
    for (const double peak : { 200.0, 600.0 })
    {
      StripePicture scene = straight(0.17, 40.0);
      scene.sigma = sigma;
      scene.peak = peak;  // 600: from the flanks beside the clipped top
      scene.bit_depth = 16;
      const Error error = measure(paramsOf("log_parabola"), scene);
      ASSERT_EQ(error.count, 600U);
      EXPECT_LE(error.rmse_mpx, 1.0) << "sigma " << sigma << ", peak " << peak;
    }
}

TEST(LogParabola, IsNotSpoiltByNoiseInTheTails)
{
  StripePicture scene = straight(3.17, 40.0);
  scene.snr = 20.0;
  const Error error = measure(paramsOf("log_parabola"), scene);
  ASSERT_EQ(error.count, 600U);
  // 72 mpx = 1.1 times the bound of one column; unweighted 7 points make it 1.5 times and more.
  EXPECT_LE(error.rmse_mpx, 80.0);
  EXPECT_NEAR(error.in_sigmas, 1.0, 0.2);
}
}  // namespace
}  // namespace weld_profiler
