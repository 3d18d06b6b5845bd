// Accuracy across the stripe, sigma 2 px, a peak 50 times its noise. benchmark/stripe_accuracy prints the same figures.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "support/extract.h"

namespace weld_profiler
{
namespace
{
struct Error
{
  double rmse_mpx = 0.0, mean_mpx = 0.0, in_sigmas = 0.0;
  std::size_t count = 0, cells = 0;
};

Error measure(const StripeParams& params, double degrees, double snr = 50.0)
{
  Error error;
  for (int run = 0; run < 6; ++run)
  {
    test_support::StripePicture scene = test_support::straight(degrees, 20.0 + 0.171 * run);
    scene.width = 300;
    scene.height = static_cast<int>(42.0 + 300.0 * std::tan(degrees * std::acos(-1.0) / 180.0));
    scene.snr = snr;
    scene.seed = 50U + static_cast<unsigned>(run);
    const Stripe stripe = test_support::extract(params, render(scene));
    error.cells += 300;
    for (std::size_t i = 0; i < stripe.size(); ++i)
    {
      const double e = 1000.0 * distanceAcross(scene, stripe.u[i], stripe.v[i]);
      error.rmse_mpx += e * e;
      error.mean_mpx += e;
      error.in_sigmas += std::pow(0.001 * e / stripe.sigma[i], 2.0);
      ++error.count;
    }
  }
  const auto n = static_cast<double>(error.count);
  error.rmse_mpx = std::sqrt(error.rmse_mpx / n);
  error.mean_mpx /= n;
  error.in_sigmas = std::sqrt(error.in_sigmas / n);
  return error;
}

class StripeAccuracy : public ::testing::TestWithParam<double>
{
};

TEST_P(StripeAccuracy, IsThatOfTheFieldOrBetter)
{
  // The bound of one column is 23 mpx here; limits are the measured values and a tenth.
  const std::map<std::string, double> limits = { { "gray_centroid", 40.0 }, { "squared_centroid", 29.0 },
                                                 { "svd", 16.0 },           { "pca", 14.0 },
                                                 { "steger", 14.0 },        { "gauss_fit", 29.0 },
                                                 { "fir_peak", 29.0 },      { "log_parabola", 35.0 } };
  for (const auto& limit : limits)
  {
    const Error error = measure(test_support::paramsOf(limit.first), GetParam() + 0.17);
    ASSERT_GE(error.count, 0.98 * static_cast<double>(error.cells)) << limit.first;
    EXPECT_LE(error.rmse_mpx, limit.second) << limit.first;
    EXPECT_LE(std::abs(error.mean_mpx), 4.0) << limit.first << ": unbiased";
    // The sigma that is told is the error that is made.
    EXPECT_GE(error.in_sigmas, 0.75) << limit.first;
    EXPECT_LE(error.in_sigmas, 1.35) << limit.first;
  }
}

INSTANTIATE_TEST_SUITE_P(Slopes, StripeAccuracy, ::testing::Values(0.0, 15.0, 30.0, 45.0));

TEST(StripeAccuracy, HasNoBiasAtAnySubPixelOffsetWithoutNoise)
{
  for (const char* method :
       { "gray_centroid", "squared_centroid", "svd", "pca", "steger", "gauss_fit", "fir_peak", "log_parabola" })
    for (double offset = 0.0; offset < 1.0; offset += 0.0625)
    {
      test_support::StripePicture scene = test_support::straight(0.0, 30.0 + offset);
      scene.width = 60;
      scene.height = 61;
      const Stripe stripe = test_support::extract(test_support::paramsOf(method), render(scene));
      ASSERT_EQ(stripe.size(), 60U);
      for (std::size_t i = 0; i < stripe.size(); ++i)
        // 15 mpx: the third order that a second-order step leaves at half a pixel.
        ASSERT_NEAR(stripe.v[i], 30.0 + offset, 0.015) << method << " at " << offset;
    }
}

TEST(StripeAccuracy, OfTheLiteralReadingIsAnOrderOfMagnitudeWorse)
{
  StripeParams letter = test_support::paramsOf("svd");
  letter.taylor = "literal";
  letter.derivatives = "sobel";
  letter.max_gap_px = 0;
  const double literal = measure(letter, 0.17).rmse_mpx;
  EXPECT_GT(literal, 10.0 * measure(test_support::paramsOf("svd"), 0.17).rmse_mpx);
}
}  // namespace
}  // namespace weld_profiler
