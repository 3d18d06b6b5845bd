#include "stripe/direction.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/render_stripe.h"

namespace weld_profiler
{
namespace
{
TEST(Transpose, TurnsRowsIntoColumns)
{
  for (const int depth : { 8, 16 })
  {
    const test_support::Picture picture = render(
        []
        {
          test_support::StripePicture scene = test_support::straight(20.0, 5.0);
          scene.width = 37;
          scene.height = 23;
          return scene;
        }());
    std::vector<std::uint8_t> memory;
    ImageView turned;
    test_support::Picture source = test_support::blank(37, 23, 0.0, depth);
    for (int v = 0; v < 23; ++v)
      for (int u = 0; u < 37; ++u)
        source.set(u, v, picture.at(u, v));
    transpose(source.view(), memory, turned);
    ASSERT_EQ(turned.width, 23);
    ASSERT_EQ(turned.height, 37);
    for (int v = 0; v < 23; ++v)
      for (int u = 0; u < 37; ++u)
        ASSERT_EQ(depth == 8 ? turned.row<std::uint8_t>(u)[v] : turned.row<std::uint16_t>(u)[v], source.at(u, v));
  }
}

TEST(LengthAlong, CountsWhatRunsAlongTheDirection)
{
  const float quarter_turn = 0.5F * static_cast<float>(std::acos(-1.0));
  Stripe stripe;
  StripePoint point;
  point.normal_angle = quarter_turn;
  for (int i = 0; i < 10; ++i)
    stripe.push_back(point);
  EXPECT_NEAR(lengthAlong(stripe), 10.0, 1e-5) << "level, seen along the rows";
  transpose(stripe);
  EXPECT_NEAR(lengthAlong(stripe), 10.0, 1e-5) << "upright, seen along the columns";
  stripe.direction = Direction::AlongU;
  EXPECT_NEAR(lengthAlong(stripe), 0.0, 1e-5) << "upright, seen along the rows";
}

TEST(Transpose, OfAStripeTwiceIsTheStripe)
{
  Stripe stripe;
  for (int i = 0; i < 20; ++i)
  {
    StripePoint point;
    point.cell = static_cast<std::uint16_t>(i);
    point.u = static_cast<float>(i);
    point.v = 50.0F + static_cast<float>(i);
    point.normal_angle = -1.5F + 0.15F * static_cast<float>(i);
    stripe.push_back(point);
  }
  const Stripe before = stripe;
  transpose(stripe);
  EXPECT_EQ(stripe.direction, Direction::AlongV);
  EXPECT_EQ(stripe.u, before.v);
  for (const float angle : stripe.normal_angle)
  {
    EXPECT_GT(angle, -0.5F * static_cast<float>(std::acos(-1.0)));
    EXPECT_LE(angle, 0.5F * static_cast<float>(std::acos(-1.0)) + 1e-6F);
  }
  transpose(stripe);
  EXPECT_EQ(stripe.direction, Direction::AlongU);
  for (std::size_t i = 0; i < before.size(); ++i)
    EXPECT_NEAR(std::remainder(stripe.normal_angle[i] - before.normal_angle[i], std::acos(-1.0)), 0.0, 1e-6);
}
}  // namespace
}  // namespace weld_profiler
