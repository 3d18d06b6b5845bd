// Which columns count: not those at the image's border, beside spatter or without light.
#include <gtest/gtest.h>

#include "stripe/column_moments.h"
#include "support/known_columns.h"
#include "support/render_stripe.h"

namespace weld_profiler
{
namespace
{
using test_support::columnSigma;
using test_support::kNoise;
using test_support::Picture;
using test_support::render;
using test_support::sceneOf;
using test_support::slotOf;
using test_support::StripePicture;
using test_support::trackOf;

TEST(ColumnWeights, CountNoColumnWhereTheStripeRunsOutOfTheImage)
{
  StripePicture scene = sceneOf(-20.0, 70.0, 2.0);
  scene.height = 90;
  ColumnTrack track = trackOf(scene);
  ColumnMoments::measure(render(scene).view(), kNoise, track);
  int inside = 0;
  int outside = 0;
  for (int u = 0; u < scene.width; ++u)
  {
    const double room = scene.row(u) / columnSigma(scene, u);  // half widths above the stripe
    if (room > 2.6)
    {
      ++inside;
      EXPECT_EQ(track.weight[slotOf(u)], 1.0F) << u;
    }
    else if (room < 2.0)
    {
      ++outside;
      EXPECT_EQ(track.weight[slotOf(u)], 0.0F) << u;
    }
  }
  EXPECT_GT(inside, 100);
  EXPECT_GT(outside, 10);
}

TEST(ColumnWeights, CountNoColumnBelowTheImage)
{
  StripePicture scene = sceneOf(0.0, 85.5, 2.0);
  scene.height = 90;  // 4.5 rows below: less than 2.5 half widths
  ColumnTrack track = trackOf(scene);
  ColumnMoments::measure(render(scene).view(), kNoise, track);
  for (int u = 0; u < scene.width; ++u)
    EXPECT_EQ(track.weight[slotOf(u)], 0.0F) << u;
}

TEST(ColumnWeights, CountNoColumnTornBySpatter)
{
  StripePicture scene = sceneOf(0.0, 80.0, 2.0);
  Picture picture = render(scene);
  for (int u = 100; u < 106; ++u)
    for (int v = 84; v < 88; ++v)
      picture.set(u, v, 65535.0);
  ColumnTrack track = trackOf(scene);
  ColumnMoments::measure(picture.view(), 257.0F * kNoise, track);
  for (int u = 0; u < scene.width; ++u)
    EXPECT_EQ(track.weight[slotOf(u)], u >= 100 && u < 106 ? 0.0F : 1.0F) << u;
}

TEST(ColumnWeights, CountNoColumnWithoutLight)
{
  StripePicture scene = sceneOf(0.0, 80.0, 2.0);
  scene.gain = [](double u) { return u < 50.0 ? 0.0 : 1.0; };
  ColumnTrack track = trackOf(scene);
  for (float& background : track.background)
    background += 1.0F;  // of 65535: darker than told
  ColumnMoments::measure(render(scene).view(), kNoise, track);
  for (int u = 0; u < scene.width; ++u)
    EXPECT_EQ(track.weight[slotOf(u)], u < 50 ? 0.0F : 1.0F) << u;
}

}  // namespace
}  // namespace weld_profiler
