// What every method promises. A method in the table is a method under test.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support/bead_scene.h"
#include "support/extract.h"

namespace weld_profiler
{
namespace
{
using test_support::beadScene;
using test_support::extract;
using test_support::paramsOf;
using test_support::Picture;
using test_support::render;
using test_support::straight;
using test_support::StripePicture;

class StripeContract : public ::testing::TestWithParam<std::string>
{
protected:
  StripeParams params(const std::string& direction = "u") const { return paramsOf(GetParam(), direction); }
};

TEST_P(StripeContract, FindsTheCentreWithinATenthOfAPixel)
{
  for (double v = 30.0; v < 31.0; v += 0.1)
  {
    StripePicture scene = straight(0.0, v);
    scene.width = 64;
    scene.height = 61;
    const Stripe stripe = extract(params(), render(scene));
    ASSERT_EQ(stripe.status, StripeStatus::Ok);
    ASSERT_EQ(stripe.size(), 64U) << "one point a column";
    for (std::size_t i = 0; i < stripe.size(); ++i)
      EXPECT_NEAR(stripe.v[i], v, 0.1) << "column " << stripe.cell[i];
  }
}

TEST_P(StripeContract, FollowsABeadWithinATenthOfAPixelAndKnowsItsOwnError)
{
  const StripePicture scene = beadScene();
  const Stripe stripe = extract(params(), render(scene));
  ASSERT_GE(stripe.size(), 392U) << "at most 2 % missing";
  double squares = 0.0;
  double in_sigmas = 0.0;
  for (std::size_t i = 0; i < stripe.size(); ++i)
  {
    const double error = distanceAcross(scene, stripe.u[i], stripe.v[i]);
    squares += error * error / static_cast<double>(stripe.size());
    in_sigmas += std::pow(error / stripe.sigma[i], 2.0) / static_cast<double>(stripe.size());
    EXPECT_NEAR(stripe.width[i], 2.0, 0.35);
    EXPECT_NEAR(stripe.intensity[i], 200.0, 25.0);
  }
  EXPECT_LE(std::sqrt(squares), 0.1);
  // An honest sigma: the errors are one sigma large, give or take what curvature adds.
  EXPECT_GT(std::sqrt(in_sigmas), 0.6);
  EXPECT_LT(std::sqrt(in_sigmas), 2.0);
}

TEST_P(StripeContract, ReturnsNothingForADarkFrame)
{
  const Stripe stripe = extract(params("auto"), test_support::blank(200, 100, 2.0));
  EXPECT_TRUE(stripe.empty());
  EXPECT_EQ(stripe.status, StripeStatus::TooDark);
}

TEST_P(StripeContract, ReturnsNothingForASaturatedFrame)
{
  const Stripe stripe = extract(params("auto"), test_support::blank(200, 100, 255.0));
  EXPECT_TRUE(stripe.empty());
  EXPECT_EQ(stripe.status, StripeStatus::TooBright);
}

TEST_P(StripeContract, ReturnsNothingForNoise)
{
  std::mt19937 random(1);
  for (const double sigma : { 2.0, 10.0, 40.0 })
  {
    Picture picture = test_support::blank(300, 200);
    std::normal_distribution<double> noise(60.0, sigma);
    for (int v = 0; v < picture.height; ++v)
      for (int u = 0; u < picture.width; ++u)
        picture.set(u, v, noise(random));
    const Stripe stripe = extract(params("auto"), picture);
    EXPECT_TRUE(stripe.empty()) << "noise of " << sigma << ", centres " << stripe.size();
    EXPECT_EQ(stripe.status, StripeStatus::NoStripe);
  }
}

TEST_P(StripeContract, ReturnsNothingForAPattern)
{
  for (const int square : { 1, 2, 4, 8, 16, 32 })
  {
    Picture picture = test_support::blank(320, 256);
    for (int v = 0; v < picture.height; ++v)
      for (int u = 0; u < picture.width; ++u)
        picture.set(u, v, (u / square + v / square) % 2 == 0 ? 220.0 : 20.0);
    const Stripe stripe = extract(params("auto"), picture);
    EXPECT_TRUE(stripe.empty()) << "squares of " << square << " px, centres " << stripe.size();
  }
}

TEST_P(StripeContract, GivesAtMostOneCentreACellInRisingOrder)
{
  StripePicture scene = beadScene();
  const StripePicture ghost = straight(-15.0, 150.0);
  Picture picture = render(scene);
  scene.row = ghost.row;
  const Picture second = render(scene);
  for (int v = 0; v < picture.height; ++v)
    for (int u = 0; u < picture.width; ++u)
      picture.set(u, v, picture.at(u, v) + 0.6 * second.at(u, v));
  const Stripe stripe = extract(params(), picture);
  ASSERT_GT(stripe.size(), 100U);
  bool ambiguous = false;
  for (std::size_t i = 0; i < stripe.size(); ++i)
  {
    EXPECT_TRUE(i == 0 || stripe.cell[i - 1] < stripe.cell[i]);
    EXPECT_NEAR(stripe.u[i], stripe.cell[i], 0.51) << "a centre belongs to its own column";
    ambiguous = ambiguous || (stripe.flags[i] & stripe_flag::kAmbiguous) != 0;
  }
  EXPECT_TRUE(ambiguous);
}

TEST_P(StripeContract, LosesAStripeThatRunsOutOfTheImage)
{
  StripePicture scene = straight(30.0, -40.0);
  scene.width = 300;
  scene.height = 100;
  scene.snr = 50.0;
  const Stripe stripe = extract(params(), render(scene));
  ASSERT_GT(stripe.size(), 140U);
  EXPECT_LT(stripe.size(), 180U);
  for (std::size_t i = 0; i < stripe.size(); ++i)
    EXPECT_NEAR(distanceAcross(scene, stripe.u[i], stripe.v[i]), 0.0, 0.3) << "cell " << stripe.cell[i];
}

TEST_P(StripeContract, SurvivesImagesSmallerThanItsTemplate)
{
  for (const int size : { 1, 2, 3, 5, 7, 9 })
    for (const double level : { 0.0, 100.0, 255.0 })
    {
      Picture picture = test_support::blank(size, size, 0.0);
      for (int u = 0; u < size; ++u)
        picture.set(u, size / 2, level);
      const Stripe stripe = extract(params("auto"), picture);
      EXPECT_LE(stripe.size(), static_cast<std::size_t>(size));
      for (std::size_t i = 0; i < stripe.size(); ++i)
        EXPECT_TRUE(std::isfinite(stripe.u[i]) && std::isfinite(stripe.v[i]) && std::isfinite(stripe.sigma[i]));
    }
}

TEST_P(StripeContract, SurvivesNarrowImagesOfEveryEncoding)
{
  struct Size
  {
    int width, height;
  };
  std::vector<std::string> encodings;
  for (const std::string name : { "mono", "rgb", "bgra", "bayer_rggb", "bayer_bggr", "bayer_gbrg", "bayer_grbg" })
    for (const char* bits : { "8", "16" })
      encodings.push_back(name + bits);
  for (const std::string& encoding : encodings)
    for (const Size size : { Size{ 1, 1 }, Size{ 1, 5 }, Size{ 5, 1 }, Size{ 20, 1 }, Size{ 1, 20 }, Size{ 2, 2 } })
      for (const char* channel : { "red", "green", "blue", "max", "luminance" })
      {
        StripeParams narrow = params("auto");
        narrow.channel = channel;
        const bool mono = encoding.find("mono") == 0 || encoding.find("bayer") == 0;
        const int bytes = (mono ? 1 : (encoding.find("rgb") == 0 ? 3 : 4)) * (encoding.back() == '6' ? 2 : 1);
        // As large as the image and no larger: an address sanitizer sees what is read beyond it.
        std::vector<std::uint8_t> pixels(static_cast<std::size_t>(size.width * size.height * bytes), 200);
        RawImage image;
        image.data = pixels.data();
        image.width = size.width;
        image.height = size.height;
        image.step = static_cast<std::size_t>(size.width * bytes);
        image.encoding = encoding;
        const Stripe stripe = extract(narrow, image);
        EXPECT_TRUE(stripe.empty()) << encoding << " " << size.width << "x" << size.height << " " << channel;
        EXPECT_NE(stripe.status, StripeStatus::Ok);
      }
}

TEST_P(StripeContract, FlagsSaturatedCentresAndKeepsThemWithinAFifthOfAPixel)
{
  StripePicture scene = beadScene();
  scene.peak = 600.0;
  scene.snr = 0.0;
  const Stripe stripe = extract(params(), render(scene));
  ASSERT_GE(stripe.size(), 392U);
  for (std::size_t i = 0; i < stripe.size(); ++i)
  {
    EXPECT_NE(stripe.flags[i] & stripe_flag::kSaturated, 0);
    EXPECT_NEAR(distanceAcross(scene, stripe.u[i], stripe.v[i]), 0.0, 0.2) << "cell " << stripe.cell[i];
  }
}

TEST_P(StripeContract, TellsNormalsBetweenMinusAndPlusAQuarterTurn)
{
  const double quarter_turn = 0.5 * std::acos(-1.0);
  std::size_t count = 0;
  for (const double degrees : { -1e-6, 0.0, 1e-6, 20.0 })
    for (const char* direction : { "u", "v" })
    {
      StripePicture scene = straight(degrees, 30.0);
      scene.width = 120;
      scene.height = 90;
      // A break: interpolated centres keep the same promise.
      scene.gain = [](double u) { return u > 50.0 && u < 58.0 ? 0.0 : 1.0; };
      const Picture picture = render(scene);
      const Stripe stripe = extract(params(direction), *direction == 'u' ? picture : transposed(picture));
      count += stripe.size();
      for (const float angle : stripe.normal_angle)
      {
        EXPECT_GT(static_cast<double>(angle), -quarter_turn) << degrees << " deg along " << direction;
        EXPECT_LE(static_cast<double>(angle), quarter_turn) << degrees << " deg along " << direction;
      }
    }
  EXPECT_GT(count, 700U);
}

TEST_P(StripeContract, RespectsWidthAndContrastLimits)
{
  const Picture picture = render(beadScene());
  StripeParams limited = params();
  limited.min_stripe_width_px = 4.0;
  EXPECT_TRUE(extract(limited, picture).empty());
  limited = params();
  limited.max_stripe_width_px = 1.0;
  EXPECT_TRUE(extract(limited, picture).empty());
  limited = params();
  limited.min_peak_counts = 240.0;
  EXPECT_TRUE(extract(limited, picture).empty());
}

INSTANTIATE_TEST_SUITE_P(EveryMethod, StripeContract, ::testing::ValuesIn(stripeMethods()),
                         [](const auto& info) { return info.param; });
}  // namespace
}  // namespace weld_profiler
