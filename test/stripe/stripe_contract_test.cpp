// What every method promises. A method in the table is a method under test.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <thread>

#include "support/extract.h"

namespace weld_profiler
{
namespace
{
using test_support::extract;
using test_support::paramsOf;
using test_support::Picture;
using test_support::render;
using test_support::straight;
using test_support::StripePicture;

/// A bead between two plates, with noise.
StripePicture beadScene()
{
  StripePicture scene;
  scene.width = 400;
  scene.height = 160;
  scene.snr = 50.0;
  scene.row = [](double u) { return 110.3 + 0.03 * u - 45.0 * std::exp(-0.5 * std::pow((u - 200.0) / 45.0, 2.0)); };
  return scene;
}

void expectSame(const Stripe& a, const Stripe& b)
{
  ASSERT_EQ(a.size(), b.size());
  ASSERT_GT(a.size(), 0U);
  EXPECT_EQ(a.cell, b.cell);
  EXPECT_EQ(a.u, b.u);
  EXPECT_EQ(a.v, b.v);
  EXPECT_EQ(a.sigma, b.sigma);
  EXPECT_EQ(a.width, b.width);
  EXPECT_EQ(a.flags, b.flags);
}

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

TEST_P(StripeContract, GivesTheSameWithAndWithoutAHint)
{
  const Picture picture = render(beadScene());
  const auto extractor = makeStripeExtractor(params());
  Workspace workspace;
  Stripe without;
  extractor->extract(picture.view(), StripeHint{}, workspace, without);
  Stripe wrong = without;
  for (float& v : wrong.v)
    v -= 40.0F;
  Stripe with;
  extractor->extract(picture.view(), StripeHint{ &without }, workspace, with);
  expectSame(without, with);
  extractor->extract(picture.view(), StripeHint{ &wrong }, workspace, with);
  expectSame(without, with);
}

TEST_P(StripeContract, SeesAStripeAlongTheColumnsAsItsMirrorImage)
{
  const Picture picture = render(beadScene());
  const Stripe along_u = extract(params("u"), picture);
  const Stripe along_v = extract(params("v"), transposed(picture));
  EXPECT_EQ(along_v.direction, Direction::AlongV);
  ASSERT_EQ(along_u.size(), along_v.size());
  ASSERT_GT(along_u.size(), 0U);
  EXPECT_EQ(along_u.u, along_v.v);
  EXPECT_EQ(along_u.v, along_v.u);
  EXPECT_EQ(along_u.cell, along_v.cell);
  for (std::size_t i = 0; i < along_u.size(); ++i)
  {
    // The direction (cos, sin) becomes (sin, cos), up to its sign.
    const double alike = std::cos(along_u.normal_angle[i]) * std::sin(along_v.normal_angle[i]) +
                         std::sin(along_u.normal_angle[i]) * std::cos(along_v.normal_angle[i]);
    EXPECT_NEAR(std::abs(alike), 1.0, 1e-5);
  }
}

TEST_P(StripeContract, FindsTheDirectionByItself)
{
  const Picture picture = render(beadScene());
  Workspace workspace;
  Stripe stripe;
  const StripeStage stage(params("auto"));
  stage.process(transposed(picture).raw(), workspace, stripe);
  EXPECT_EQ(stripe.direction, Direction::AlongV);
  EXPECT_GE(stripe.size(), 392U);
  ASSERT_TRUE(workspace.direction.has_value());
  EXPECT_EQ(*workspace.direction, Direction::AlongV);
  workspace.reset();
  stage.process(picture.raw(), workspace, stripe);
  EXPECT_EQ(stripe.direction, Direction::AlongU);
}

TEST_P(StripeContract, SeesSixteenBitsAsItSeesEight)
{
  const Picture narrow = render(beadScene());
  Picture wide = test_support::blank(narrow.width, narrow.height, 0.0, 16);
  for (int v = 0; v < narrow.height; ++v)
    for (int u = 0; u < narrow.width; ++u)
      wide.set(u, v, 257.0 * narrow.at(u, v));
  const Stripe eight = extract(params(), narrow);
  const Stripe sixteen = extract(params(), wide);
  ASSERT_EQ(eight.cell, sixteen.cell);
  ASSERT_GT(eight.size(), 0U);
  for (std::size_t i = 0; i < eight.size(); ++i)
  {
    EXPECT_NEAR(eight.u[i], sixteen.u[i], 2e-3);
    EXPECT_NEAR(eight.v[i], sixteen.v[i], 2e-3);
    EXPECT_NEAR(257.0 * eight.intensity[i], sixteen.intensity[i], 300.0);
  }
}

TEST_P(StripeContract, TellsARegionsCentresInPixelsOfTheWholeImage)
{
  const Picture picture = render(beadScene());
  StripeParams region = params();
  region.max_gap_px = 0;
  const Stripe whole = extract(region, picture);
  region.roi_x = 60;
  region.roi_y = 20;
  region.roi_width = 300;
  region.roi_height = 130;
  const Stripe part = extract(region, picture);
  ASSERT_GE(part.size(), 290U);
  EXPECT_GE(part.cell.front(), 60);
  EXPECT_LT(part.cell.back(), 360);
  for (std::size_t i = 20; i + 20 < part.size(); ++i)
    EXPECT_NEAR(part.v[i], whole.v[part.cell[i]], 0.05) << "cell " << part.cell[i];
}

TEST_P(StripeContract, ServesSeveralThreadsAtOnce)
{
  const Picture picture = render(beadScene());
  const StripeStage stage(params());
  Stripe results[4];
  std::vector<std::thread> threads;
  for (Stripe& result : results)
    threads.emplace_back(
        [&stage, &picture, &result]
        {
          Workspace workspace;
          for (int i = 0; i < 5; ++i)
            stage.process(picture.raw(), workspace, result);
        });
  for (std::thread& thread : threads)
    thread.join();
  for (const Stripe& result : results)
    expectSame(results[0], result);
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
