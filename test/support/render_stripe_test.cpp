// The drawn truth itself: what tests and benchmarks believe.
#include <gtest/gtest.h>

#include <cmath>

#include "support/bead_scene.h"
#include "support/integrate_stripe.h"
#include "support/render_stripe.h"

namespace
{
using namespace weld_profiler::test_support;  // NOLINT

struct Moments
{
  double light = 0.0, middle = 0.0, width = 0.0;
};

/// Of the light above background in a column.
Moments momentsOf(const Picture& picture, int u, double background)
{
  Moments moments;
  double squares = 0.0;
  for (int v = 0; v < picture.height; ++v)
  {
    const double light = picture.at(u, v) - background;
    moments.light += light;
    moments.middle += light * v;
    squares += light * v * v;
  }
  moments.middle /= moments.light;
  moments.width = std::sqrt(squares / moments.light - moments.middle * moments.middle);
  return moments;
}

StripePicture level()
{
  StripePicture scene = straight(0.0, 60.3);
  scene.bit_depth = 16;
  return scene;
}

TEST(RenderStripe, AgreesWithTheRenderingThatIntegratesOverPixels)
{
  for (const double degrees : { 0.0, 20.0, 50.0 })
  {
    StripePicture scene = straight(degrees, 40.3);
    scene.width = 60;
    scene.height = 180;
    scene.bit_depth = 16;
    const Picture sampled = render(scene), integrated = renderIntegrated(scene);
    for (int u = 5; u < 55; ++u)
    {
      const Moments a = momentsOf(sampled, u, 257.0 * scene.background);
      const Moments b = momentsOf(integrated, u, 257.0 * scene.background);
      ASSERT_NEAR(a.middle, scene.row(u), 1e-3) << degrees << " deg, column " << u;
      ASSERT_NEAR(b.middle, scene.row(u), 1e-3) << degrees << " deg, column " << u;
      // A pixel's box, 1/12 px^2 of variance each way, seen along the column.
      const double box = (1.0 + std::pow(scene.slope(u), 2.0)) / 12.0;
      ASSERT_NEAR(b.width * b.width - a.width * a.width, box, 0.01) << degrees << " deg, column " << u;
    }
  }
}

TEST(RenderStripe, AgreesWithTheOtherRenderingOnACurve)
{
  StripePicture scene = beadScene();
  scene.snr = 0.0;
  scene.bit_depth = 16;
  const Picture sampled = render(scene), integrated = renderIntegrated(scene);
  for (int u = 20; u < scene.width - 20; ++u)
  {
    const double a = momentsOf(sampled, u, 257.0 * scene.background).middle;
    const double b = momentsOf(integrated, u, 257.0 * scene.background).middle;
    ASSERT_NEAR(a, b, 0.01) << "column " << u;
  }
}

TEST(RenderStripe, DrawsTheWidthThatIsAskedForAtEachColumn)
{
  StripePicture scene = level();
  scene.sigma_at = [](double u) { return u < 160.0 ? 1.5 : 4.0; };
  const Picture picture = render(scene);
  EXPECT_NEAR(momentsOf(picture, 80, 257.0 * scene.background).width, 1.5, 0.01);
  EXPECT_NEAR(momentsOf(picture, 240, 257.0 * scene.background).width, 4.0, 0.01);
}

TEST(RenderStripe, DrawsTheProfileThatIsAskedForWithItsUpperSideUp)
{
  StripePicture scene = level();
  scene.profile = [](double d) { return d < 0.0 ? std::exp(-0.5 * d * d) : std::exp(-0.5 * d * d / 9.0); };
  const Moments moments = momentsOf(render(scene), 100, 257.0 * scene.background);
  // Two half Gaussians of 1 and 3 px: the mean lies sqrt(2 / pi) (3 - 1) below their common peak.
  EXPECT_NEAR(moments.middle - 60.3, std::sqrt(2.0 / std::acos(-1.0)) * 2.0, 0.01);
}

TEST(RenderStripe, GivesReadAndShotNoiseAsTold)
{
  StripePicture scene = level();
  scene.bit_depth = 8;
  scene.peak = 1e-6;
  scene.background = 40.0;
  scene.read_noise = 3.0;
  scene.shot_gain = 0.5;
  scene.more_light.assign(static_cast<std::size_t>(scene.width) * static_cast<std::size_t>(scene.height), 0.0);
  for (std::size_t i = scene.more_light.size() / 2; i < scene.more_light.size(); ++i)
    scene.more_light[i] = 100.0;
  const Picture picture = render(scene);
  for (const bool lit : { false, true })
  {
    double sum = 0.0, squares = 0.0, count = 0.0;
    for (int v = lit ? scene.height / 2 : 0; v < (lit ? scene.height : scene.height / 2); ++v)
      for (int u = 0; u < scene.width; ++u, ++count)
      {
        sum += picture.at(u, v);
        squares += std::pow(picture.at(u, v), 2.0);
      }
    const double mean = sum / count, variance = squares / count - mean * mean;
    EXPECT_NEAR(mean, lit ? 140.0 : 40.0, 0.2);
    // 19200 pixels: 1 % of the variance; rounding adds 1/12.
    EXPECT_NEAR(variance, (lit ? 59.0 : 9.0) + 1.0 / 12.0, lit ? 2.5 : 0.4);
  }
}

TEST(RenderStripe, ExposesTheSameLightAgain)
{
  StripePicture scene = beadScene();
  EXPECT_EQ(render(scene).bytes, render(scene, lightOf(scene)).bytes);
}
}  // namespace
