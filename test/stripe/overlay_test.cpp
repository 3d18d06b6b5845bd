#include "weld_profiler/stripe/overlay.h"

#include <gtest/gtest.h>

#include "support/extract.h"
#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
namespace
{
int countColour(const cv::Mat& picture, const cv::Vec3b& colour)
{
  int count = 0;
  for (int v = 0; v < picture.rows; ++v)
    for (int u = 0; u < picture.cols; ++u)
      count += picture.at<cv::Vec3b>(v, u) == colour ? 1 : 0;
  return count;
}

TEST(Overlay, ShowsThePapersFigureSevenInItsColours)
{
  test_support::StripePicture scene = test_support::straight(15.0, 12.0);
  scene.width = 80;
  scene.height = 50;
  scene.snr = 50.0;
  scene.peak = 120.0;
  scene.gain = [](double u) { return u > 38.0 && u < 44.0 ? 0.0 : 1.0; };
  const test_support::Picture picture = render(scene);
  Workspace workspace;
  workspace.keep_trace = true;
  Stripe stripe;
  StripeStage(test_support::paramsOf("svd")).process(picture.raw(), workspace, stripe);
  ASSERT_GT(stripe.size(), 70U);
  const cv::Mat drawn = drawStripe(picture.raw(), stripe, workspace.initial, 16);
  ASSERT_EQ(drawn.cols, 1280);
  ASSERT_EQ(drawn.rows, 800);
  ASSERT_EQ(drawn.type(), CV_8UC3);
  EXPECT_GT(countColour(drawn, { 0, 255, 255 }), 70) << "yellow: pixel blocks";
  EXPECT_GT(countColour(drawn, { 0, 0, 255 }), 70) << "red: initial points and the curve";
  EXPECT_GT(countColour(drawn, { 255, 64, 0 }), 200) << "blue: exact points";
  EXPECT_GT(countColour(drawn, { 0, 255, 0 }), 15) << "green: interpolated points";
  int white = 0;  // lines are smoothed: nearly white counts
  for (int v = 0; v < drawn.rows; ++v)
    for (int u = 0; u < drawn.cols; ++u)
    {
      const cv::Vec3b& pixel = drawn.at<cv::Vec3b>(v, u);
      white += pixel[0] > 200 && pixel[1] > 200 && pixel[2] > 200 ? 1 : 0;
    }
  EXPECT_GT(white, 1000) << "white: normals";
}

TEST(Overlay, LeavesTheImageAsItIsWithoutAStripe)
{
  for (const int depth : { 8, 16 })
  {
    const test_support::Picture picture = test_support::blank(30, 20, depth == 8 ? 40.0 : 4000.0, depth);
    const cv::Mat drawn = drawStripe(picture.raw(), Stripe{}, {}, 1);
    ASSERT_EQ(drawn.cols, 30);
    const int level = depth == 8 ? 40 : 255;
    EXPECT_EQ(countColour(drawn, cv::Vec3b(level, level, level)), 600);
  }
}

TEST(Overlay, RefusesAScaleOutOfRange)
{
  const test_support::Picture picture = test_support::blank(30, 20);
  EXPECT_THROW(drawStripe(picture.raw(), Stripe{}, {}, 0), PreconditionError);
  EXPECT_THROW(drawStripe(picture.raw(), Stripe{}, {}, 17), PreconditionError);
}
}  // namespace
}  // namespace weld_profiler
