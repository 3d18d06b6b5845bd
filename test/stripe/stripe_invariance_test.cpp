// What must not change a method's result: hint, direction, depth, region, threads.
#include <gtest/gtest.h>

#include <cmath>
#include <thread>

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

class StripeInvariance : public ::testing::TestWithParam<std::string>
{
protected:
  StripeParams params(const std::string& direction = "u") const { return paramsOf(GetParam(), direction); }
};

TEST_P(StripeInvariance, GivesTheSameWithAndWithoutAHint)
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

TEST_P(StripeInvariance, SeesAStripeAlongTheColumnsAsItsMirrorImage)
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

TEST_P(StripeInvariance, FindsTheDirectionByItself)
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

TEST_P(StripeInvariance, SeesSixteenBitsAsItSeesEight)
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

TEST_P(StripeInvariance, TellsARegionsCentresInPixelsOfTheWholeImage)
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

TEST_P(StripeInvariance, ServesSeveralThreadsAtOnce)
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

INSTANTIATE_TEST_SUITE_P(EveryMethod, StripeInvariance, ::testing::ValuesIn(stripeMethods()),
                         [](const auto& info) { return info.param; });
}  // namespace
}  // namespace weld_profiler
