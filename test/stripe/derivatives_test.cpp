#include "stripe/derivatives.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "stripe/axis.h"
#include "stripe/taylor_step.h"
#include "support/render_stripe.h"

namespace weld_profiler
{
namespace
{
using test_support::Picture;

/// gray = 100 + 3 x - 2 y + 0.5 x^2 + 1.5 x y - y^2 about the middle of an image: every derivative is known.
Picture quadric()
{
  Picture picture = test_support::blank(41, 41, 0.0, 16);
  for (int v = 0; v < 41; ++v)
    for (int u = 0; u < 41; ++u)
    {
      const int x = u - 20;
      const int y = v - 20;
      picture.set(u, v, 10000.0 + 30 * x - 20 * y + 5 * x * x + 15 * x * y - 10 * y * y);
    }
  return picture;
}

void expectDerivativesOfTheQuadric(const DerivativeKernel& kernel)
{
  const Picture picture = quadric();
  const Derivatives d = kernel.at(picture.view(), 20, 20);
  EXPECT_NEAR(d.x, 30.0, 1e-8);
  EXPECT_NEAR(d.y, -20.0, 1e-8);
  EXPECT_NEAR(d.xx, 10.0, 1e-8);
  EXPECT_NEAR(d.xy, 15.0, 1e-8);
  EXPECT_NEAR(d.yy, -20.0, 1e-8);
}

TEST(Derivatives, OfAQuadricAreExactWithSobel)
{
  DerivativeKernel kernel;
  kernel.setSobel(DerivativeKernel::Sobel::Scaled);
  expectDerivativesOfTheQuadric(kernel);
}

TEST(Derivatives, OfAQuadricAreExactWithAnyGaussian)
{
  for (const double sigma : { 1.0, 1.7, 2.31, 4.0 })
  {
    DerivativeKernel kernel;
    kernel.setGaussian(sigma);
    expectDerivativesOfTheQuadric(kernel);
  }
}

TEST(Derivatives, BySobelAreOpenCvsDividedByTheGains)
{
  test_support::StripePicture stripe = test_support::straight(20.0, 12.0);
  stripe.width = 40;
  stripe.height = 40;
  stripe.snr = 20.0;
  const Picture picture = test_support::render(stripe);
  const cv::Mat image(40, 40, CV_8U, const_cast<std::uint8_t*>(picture.bytes.data()));
  cv::Mat x, y, xx, xy, yy;
  cv::Sobel(image, x, CV_64F, 1, 0);
  cv::Sobel(image, y, CV_64F, 0, 1);
  cv::Sobel(image, xx, CV_64F, 2, 0);
  cv::Sobel(image, xy, CV_64F, 1, 1);
  cv::Sobel(image, yy, CV_64F, 0, 2);
  DerivativeKernel scaled;
  scaled.setSobel(DerivativeKernel::Sobel::Scaled);
  DerivativeKernel unscaled;
  unscaled.setSobel(DerivativeKernel::Sobel::Unscaled);
  for (int v = 5; v < 35; ++v)
    for (int u = 5; u < 35; ++u)
    {
      const Derivatives d = scaled.at(picture.view(), u, v);
      ASSERT_NEAR(d.x, x.at<double>(v, u) / 8.0, 1e-9);
      ASSERT_NEAR(d.y, y.at<double>(v, u) / 8.0, 1e-9);
      ASSERT_NEAR(d.xx, xx.at<double>(v, u) / 4.0, 1e-9);
      ASSERT_NEAR(d.xy, xy.at<double>(v, u) / 4.0, 1e-9);
      ASSERT_NEAR(d.yy, yy.at<double>(v, u) / 4.0, 1e-9);
      // Only the proportion of first to second derivatives matters to a Taylor step.
      const Derivatives raw = unscaled.at(picture.view(), u, v);
      ASSERT_NEAR(raw.y * 4.0, y.at<double>(v, u), 1e-9);
      ASSERT_NEAR(raw.xy * 4.0, xy.at<double>(v, u), 1e-9);
    }
}

TEST(TaylorStep, GoesToTheTopOfAParabola)
{
  const TemplateNormal up{ true, 0.0, 1.0 };
  Derivatives d;
  d.y = 3.0;
  d.yy = -10.0;
  const TaylorStep step = taylorStep(d, up);
  ASSERT_TRUE(step.maximum);
  EXPECT_DOUBLE_EQ(step.t, 0.3);
  d.yy = 10.0;
  EXPECT_FALSE(taylorStep(d, up).maximum) << "a valley has no top";
}

TEST(SmallerAxis, PointsAcrossARidge)
{
  for (const double angle : { 0.0, 0.1, 0.785398, 0.9, 1.5707963, 2.4 })
  {
    // A ridge: curvature -4 across, -0.1 along.
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const double xx = -4.0 * c * c - 0.1 * s * s;
    const double xy = (-4.0 + 0.1) * c * s;
    const double yy = -4.0 * s * s - 0.1 * c * c;
    double u = 0.0;
    double v = 0.0;
    EXPECT_NEAR(smallerAxis(xx - yy, 2.0 * xy, u, v), 3.9, 1e-9) << "the eigenvalues' difference";
    EXPECT_NEAR(u, c, 1e-9) << angle;
    EXPECT_NEAR(v, s, 1e-9) << angle;
    float u_single = 0.0F;
    float v_single = 0.0F;
    smallerAxis(static_cast<float>(xx - yy), static_cast<float>(2.0 * xy), u_single, v_single);
    EXPECT_NEAR(u_single, c, 1e-6) << angle;
    EXPECT_NEAR(v_single, s, 1e-6) << angle;
  }
}
}  // namespace
}  // namespace weld_profiler
