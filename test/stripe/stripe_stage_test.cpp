#include "weld_profiler/stripe/stripe_stage.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/extract.h"
#include "weld_profiler/core/errors.h"

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

/// The mosaic of a scene lit by a red laser: red photosites see it, the others a twentieth.
Picture mosaic(const StripePicture& scene, int red_u, int red_v)
{
  Picture picture = render(scene);
  for (int v = 0; v < picture.height; ++v)
    for (int u = 0; u < picture.width; ++u)
      if (u % 2 != red_u || v % 2 != red_v)
        picture.set(u, v, scene.background + 0.05 * (picture.at(u, v) - scene.background));
  return picture;
}

TEST(StripeStage, SeesRedPhotositesAtTheirOwnPlaces)
{
  StripePicture scene = straight(8.0, 40.0);
  scene.width = 300;
  scene.height = 140;
  scene.sigma = 3.0;
  scene.snr = 50.0;
  const char* const names[] = { "bayer_rggb8", "bayer_grbg8", "bayer_gbrg8", "bayer_bggr8" };
  for (int site = 0; site < 4; ++site)
  {
    const Picture picture = mosaic(scene, site % 2, site / 2);
    RawImage image = picture.raw();
    image.encoding = names[site];
    for (const std::string& method : stripeMethods())
    {
      const Stripe stripe = extract(paramsOf(method), image);
      ASSERT_GE(stripe.size(), 146U) << method;
      double mean = 0.0;
      for (std::size_t i = 0; i < stripe.size(); ++i)
      {
        EXPECT_EQ(stripe.cell[i] % 2, site % 2);
        EXPECT_NEAR(stripe.u[i], stripe.cell[i], 1.01);
        EXPECT_NEAR(stripe.width[i], 3.0, 0.4);
        mean += distanceAcross(scene, stripe.u[i], stripe.v[i]) / static_cast<double>(stripe.size());
      }
      // A shift by half a pixel of the mosaic would show as 0.5 px.
      EXPECT_NEAR(mean, 0.0, 0.03) << method << " on " << names[site];
    }
  }
}

TEST(StripeStage, RefusesAnImageWithoutPixels)
{
  RawImage image;
  image.encoding = "mono8";
  EXPECT_THROW(extract(StripeParams{}, image), PreconditionError);
}

TEST(StripeStage, RefusesARegionOutsideTheImage)
{
  StripeParams params;
  params.roi_x = 100;
  EXPECT_THROW(extract(params, test_support::blank(100, 50)), PreconditionError);
  params.roi_x = 0;
  params.roi_y = 50;
  EXPECT_THROW(extract(params, test_support::blank(100, 50)), PreconditionError);
}

TEST(StripeStage, CutsARegionThatReachesBeyondTheImage)
{
  StripePicture scene = straight(0.0, 40.0);
  scene.width = 200;
  scene.height = 80;
  StripeParams params = paramsOf("squared_centroid");
  params.roi_x = 150;
  params.roi_width = 500;
  const Stripe stripe = extract(params, render(scene));
  ASSERT_EQ(stripe.size(), 50U);
  EXPECT_EQ(stripe.cell.front(), 150);
}

TEST(StripeStage, GivesOneInitialPointACentreWhenAskedForATrace)
{
  StripePicture scene = straight(10.0, 30.0);
  scene.width = 200;
  scene.height = 120;
  scene.snr = 50.0;
  const Picture picture = render(scene);
  for (const std::string& method : stripeMethods())
  {
    StripeParams params = paramsOf(method);
    params.max_gap_px = 0;
    params.roi_x = 11;
    params.roi_y = 7;
    Workspace workspace;
    Stripe stripe;
    const StripeStage stage(params);
    stage.process(picture.raw(), workspace, stripe);
    EXPECT_TRUE(workspace.initial.empty());
    workspace.keep_trace = true;
    stage.process(picture.raw(), workspace, stripe);
    ASSERT_EQ(workspace.initial.size(), stripe.size()) << method;
    ASSERT_GT(stripe.size(), 100U);
    for (std::size_t i = 0; i < stripe.size(); ++i)
    {
      EXPECT_EQ(workspace.initial[i].block_u, stripe.cell[i]);
      EXPECT_NEAR(workspace.initial[i].block_v, workspace.initial[i].v, 0.5001);
      EXPECT_NEAR(workspace.initial[i].v, stripe.v[i], 0.7);
    }
  }
}

TEST(StripeStage, TellsASixteenBitCamerasSaturationLevel)
{
  // A 12-bit camera: clipped at 4095 of 65535.
  StripePicture scene = straight(0.0, 40.0);
  scene.width = 120;
  scene.height = 80;
  const Picture eight = render(scene);
  Picture twelve = test_support::blank(120, 80, 0.0, 16);
  for (int v = 0; v < 80; ++v)
    for (int u = 0; u < 120; ++u)
      twelve.set(u, v, std::min(4095.0, 30.0 * eight.at(u, v)));
  StripeParams params = paramsOf("squared_centroid");
  EXPECT_EQ(extract(params, twelve).flags.front() & stripe_flag::kSaturated, 0);
  params.saturation_level = 4095.0;
  const Stripe stripe = extract(params, twelve);
  ASSERT_EQ(stripe.size(), 120U);
  EXPECT_NE(stripe.flags.front() & stripe_flag::kSaturated, 0);
}

TEST(StripeStage, IsNotToldTheDirectionByASpeck)
{
  StripePicture scene = straight(0.0, 60.0);
  scene.width = 200;
  scene.height = 120;
  const Picture stripe_along_u = render(scene);
  StripePicture upright = straight(0.0, 50.0);  // turned, it stands upright
  upright.width = 120;
  upright.height = 200;
  upright.gain = [](double u) { return u >= 80.0 && u < 95.0 ? 1.0 : 0.0; };
  const Picture speck = transposed(render(upright));
  Workspace workspace;
  Stripe stripe;
  const StripeStage stage(paramsOf("squared_centroid", "auto"));
  stage.process(speck.raw(), workspace, stripe);
  ASSERT_GE(stripe.size(), 10U) << "the better direction serves this frame";
  EXPECT_EQ(stripe.direction, Direction::AlongV);
  EXPECT_FALSE(workspace.direction.has_value());
  stage.process(stripe_along_u.raw(), workspace, stripe);
  EXPECT_EQ(stripe.size(), 200U);
  EXPECT_EQ(stripe.direction, Direction::AlongU);
  ASSERT_TRUE(workspace.direction.has_value());
  EXPECT_EQ(*workspace.direction, Direction::AlongU);
  stage.process(speck.raw(), workspace, stripe);
  EXPECT_EQ(stripe.direction, Direction::AlongU) << "kept";
}

TEST(StripeStage, KeepsNoDirectionThatIsInDoubt)
{
  StripePicture scene = straight(45.0, -20.0);
  scene.width = scene.height = 200;
  Workspace workspace;
  Stripe stripe;
  StripeStage(paramsOf("squared_centroid", "auto")).process(render(scene).raw(), workspace, stripe);
  EXPECT_GE(stripe.size(), 150U);
  EXPECT_FALSE(workspace.direction.has_value());
}
}  // namespace
}  // namespace weld_profiler
