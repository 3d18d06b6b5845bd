// One column at a time, noise-free: offset, width and light of stripes that are known.
#include "stripe/column_moments.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/known_columns.h"
#include "support/on_path.h"
#include "support/render_stripe.h"

namespace weld_profiler
{
namespace
{
using test_support::columnSigma;
using test_support::kNoise;
using test_support::OnPath;
using test_support::Picture;
using test_support::render;
using test_support::sceneOf;
using test_support::slotOf;
using test_support::StripePicture;
using test_support::trackOf;

/// Of one column, from a straight, level stripe in all of them.
struct Column
{
  double core, flanks, spread, light;
};

Column measured(double row, double sigma, double off, double sigma_told)
{
  const StripePicture scene = sceneOf(0.0, row, sigma);
  ColumnTrack track = trackOf(scene, off);
  std::fill(track.sigma.begin(), track.sigma.end(), static_cast<float>(sigma_told));
  ColumnMoments::measure(render(scene).view(), kNoise, track);
  const std::size_t slot = slotOf(scene.width / 2);
  EXPECT_EQ(track.weight[slot], 1.0F);
  return Column{ track.core[slot], track.flanks[slot], track.spread[slot], track.light[slot] / 257.0 };
}

TEST(ColumnMoments, TellCentreWidthAndLightAtEverySubPixelPlace)
{
  for (const double sigma : { 1.2, 1.5, 2.0, 3.0, 5.0 })
    for (double place = 0.0; place < 1.0; place += 0.125)
    {
      const Column column = measured(80.0 + place, sigma, 0.0, sigma);
      // Pixels sample the weights: at 1.2 px their sum is known to 1e-4, beyond far better. The flanks' weights are
      // narrower.
      EXPECT_NEAR(column.core, 0.0, 1e-3) << sigma << " at " << place;
      EXPECT_NEAR(column.flanks, 0.0, sigma < 1.4 ? 0.02 : 3e-3) << sigma << " at " << place;
      EXPECT_NEAR(column.spread, 1.0, 4e-3) << sigma << " at " << place;
      EXPECT_NEAR(column.light, 200.0, 0.2) << sigma << " at " << place;
    }
}

TEST(ColumnMoments, AreLinearWhereTheReferenceLineIsOff)
{
  for (const double sigma : { 1.5, 2.0, 5.0 })
    for (const double share : { -0.3, -0.06, 0.06, 0.3 })
    {
      const Column column = measured(80.3, sigma, -share * sigma, sigma);
      // t^6 is a Gaussian to half a percent of its own width: as much of the offset.
      EXPECT_NEAR(column.core, share * sigma, 5e-3 * std::abs(share) * sigma + 1e-3) << sigma << ", " << share;
      if (std::abs(share) > 0.1)
        continue;
      // The reference line is moved where it is more than 0.06 half widths off; up to there the flanks count.
      EXPECT_NEAR(column.flanks, share * sigma, 0.05 * std::abs(share) * sigma + 3e-3) << sigma << ", " << share;
    }
}

TEST(ColumnMoments, TellAWidthThatIsNotTheOneExpected)
{
  for (const double told : { 0.8, 0.9, 1.1, 1.25 })
  {
    const Column column = measured(80.4, 2.5, 0.0, 2.5 * told);
    EXPECT_NEAR(std::sqrt(column.spread) * told, 1.0, 0.02) << told;
  }
}

TEST(ColumnMoments, TakeBackgroundAndItsGradientOff)
{
  StripePicture scene = sceneOf(10.0, 60.0, 2.0);
  scene.ambient = [&](double u, double v) { return 0.5 * (v - scene.row(u)) + 20.0; };
  ColumnTrack track = trackOf(scene);
  for (std::size_t i = 0; i < track.slots(); ++i)
  {
    track.background[i] += 257.0F * 20.0F;
    track.gradient[i] = 257.0F * 0.5F;
  }
  ColumnMoments::measure(render(scene).view(), kNoise, track);
  for (int u = 0; u < scene.width; ++u)
  {
    ASSERT_EQ(track.weight[slotOf(u)], 1.0F) << u;
    EXPECT_NEAR(track.core[slotOf(u)], 0.0F, 1e-3) << u;
    EXPECT_NEAR(track.light[slotOf(u)] / 257.0, 200.0, 0.2) << u;
  }
}

/// What changing light along an oblique stripe feigns: sigma^2 slope / (1 + slope^2) d ln(light) / du.
TEST(ColumnMoments, FeignAnOffsetByReflectanceExactlyAsTheIdentitySays)
{
  for (const double degrees : { -45.0, 30.0, 45.0 })
    for (const double period : { 20.0, 40.0 })
    {
      StripePicture scene = sceneOf(degrees, degrees < 0.0 ? 225.0 : 20.0, 2.0);
      scene.height = 250;
      scene.peak = 150.0;
      scene.gain = [period](double u) { return 1.0 + 0.4 * std::sin(2.0 * M_PI * u / period); };
      ColumnTrack track = trackOf(scene);
      ColumnMoments::measure(render(scene).view(), kNoise, track);
      double largest = 0.0;
      double worst = 0.0;
      for (int u = 8; u < scene.width - 8; ++u)
      {
        const std::size_t slot = slotOf(u);
        ASSERT_EQ(track.weight[slot], 1.0F) << u;
        const auto log_light = [&](int k) { return std::log(static_cast<double>(track.light[slotOf(u + k)])); };
        // Derivative to fourth order: of a sine of 20 columns 3e-4 is missing.
        const double change = (8.0 * (log_light(1) - log_light(-1)) - (log_light(2) - log_light(-2))) / 12.0;
        const double slope = scene.slope(u);
        const double feigned = std::pow(columnSigma(scene, u), 2.0) * slope / (1.0 + slope * slope) * change;
        largest = std::max(largest, std::abs(feigned));
        worst = std::max(worst, std::abs(track.core[slot] - feigned));
      }
      EXPECT_GT(largest, 0.1) << degrees;
      // t^6 is no Gaussian in the last percent, nor is the derivative exact.
      EXPECT_LT(worst, 0.02 * largest) << degrees << " deg, period " << period << ", largest " << largest;
    }
}

TEST(ColumnMoments, TellTheBrightestPixelNearTheCentre)
{
  StripePicture scene = sceneOf(0.0, 80.0, 2.0);
  scene.bit_depth = 8;
  scene.peak = 400.0;
  ColumnTrack track = trackOf(scene);
  ColumnMoments::measure(render(scene).view(), kNoise, track);
  for (int u = 0; u < scene.width; ++u)
    EXPECT_EQ(track.peak[slotOf(u)], 255.0F) << u;
}

TEST(ColumnMoments, OfAFirstLookAreTheSame)
{
  const StripePicture scene = sceneOf(7.0, 60.0, 2.2);
  const Picture picture = render(scene);
  ColumnTrack first = trackOf(scene, 0.4);
  ColumnTrack whole = trackOf(scene, 0.4);
  ColumnMoments::locate(picture.view(), kNoise, first);
  ColumnMoments::measure(picture.view(), kNoise, whole);
  for (int u = 0; u < scene.width; ++u)
  {
    EXPECT_EQ(first.weight[slotOf(u)], whole.weight[slotOf(u)]) << u;
    EXPECT_NEAR(first.core[slotOf(u)], whole.core[slotOf(u)], 1e-5) << u;
    EXPECT_NEAR(first.spread[slotOf(u)], whole.spread[slotOf(u)], 1e-5) << u;
  }
}

TEST(ColumnMoments, AreTheSameOnBothPathsAndForBothDepths)
{
  StripePicture scene = sceneOf(25.0, 30.0, 2.0);
  scene.snr = 40.0;
  for (const int bit_depth : { 8, 16 })
  {
    scene.bit_depth = bit_depth;
    const Picture picture = render(scene);
    ColumnTrack plain = trackOf(scene, 0.3);
    ColumnTrack wide = trackOf(scene, 0.3);
    {
      const OnPath on(VectorPath::Plain);
      ColumnMoments::measure(picture.view(), 3.0F, plain);
    }
    {
      const OnPath on(widestVectorPath());
      ColumnMoments::measure(picture.view(), 3.0F, wide);
    }
    for (int u = 0; u < scene.width; ++u)
    {
      const std::size_t slot = slotOf(u);
      ASSERT_EQ(plain.weight[slot], 1.0F) << u;
      ASSERT_EQ(wide.weight[slot], 1.0F) << u;
      // Rounding of sums of 20 products, over the flanks' gain of 0.011.
      EXPECT_NEAR(plain.core[slot], wide.core[slot], 1e-5) << u;
      EXPECT_NEAR(plain.flanks[slot], wide.flanks[slot], 2e-4) << u;
      EXPECT_EQ(plain.peak[slot], wide.peak[slot]) << u;
    }
  }
}
}  // namespace
}  // namespace weld_profiler
