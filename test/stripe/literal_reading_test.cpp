// The paper's text to the letter, against a second implementation by OpenCV and Eigen that follows the text line by
// line.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "support/extract.h"

namespace weld_profiler
{
namespace
{
using test_support::Picture;

struct Letter
{
  bool kept = false;
  bool at_limit = false;
  double u = 0.0, v = 0.0;
};

/// Sections 2.2 to 2.5 for one column.
Letter byTheLetter(const cv::Mat& filtered, double threshold, int u)
{
  Letter result;
  double weight = 0.0, moment = 0.0;
  for (int v = 0; v < filtered.rows; ++v)
  {
    const double gray = filtered.at<std::uint8_t>(v, u);
    if (gray > threshold)
    {
      weight += gray * gray;
      moment += gray * gray * v;
    }
  }
  if (weight == 0.0)
    return result;
  const double y_c = moment / weight;
  const int v = static_cast<int>(std::lround(y_c));
  Eigen::Matrix<double, 49, 3> p;
  for (int i = 0; i < 49; ++i)
    p.row(i) << i % 7 - 3, i / 7 - 3, filtered.at<std::uint8_t>(v + i / 7 - 3, u + i % 7 - 3);
  const Eigen::JacobiSVD<Eigen::Matrix<double, 49, 3>> svd(p, Eigen::ComputeFullV);
  const Eigen::Vector2d n = svd.matrixV().col(2).head<2>().normalized();
  cv::Mat d[5];
  const int orders[5][2] = { { 1, 0 }, { 0, 1 }, { 2, 0 }, { 1, 1 }, { 0, 2 } };
  const cv::Mat around = filtered(cv::Rect(u - 3, v - 3, 7, 7)).clone();
  for (int i = 0; i < 5; ++i)
    cv::Sobel(around, d[i], CV_64F, orders[i][0], orders[i][1]);
  const auto at = [&](int i) { return d[i].at<double>(3, 3); };
  const double bend = n.x() * n.x() * at(2) + 2.0 * n.x() * n.y() * at(3) + n.y() * n.y() * at(4);
  const double t = -(n.x() * at(0) + n.y() * at(1)) / bend;
  result.kept = bend < 0.0 && std::abs(t * n.x()) <= 0.5 && std::abs(t * n.y()) <= 0.5;
  result.at_limit = std::abs(std::abs(t * n.x()) - 0.5) < 1e-3 || std::abs(std::abs(t * n.y()) - 0.5) < 1e-3;
  result.u = u + t * n.x();
  result.v = y_c + t * n.y();
  return result;
}

TEST(LiteralReading, IsThePapersTextLineByLine)
{
  test_support::StripePicture scene = test_support::straight(12.0, 30.0);
  scene.width = 300;
  scene.height = 150;
  scene.snr = 50.0;
  const Picture picture = render(scene);
  StripeParams params = test_support::paramsOf("svd");
  params.taylor = "literal";
  params.derivatives = "sobel";
  params.max_gap_px = 0;
  const Stripe stripe = test_support::extract(params, picture);
  ASSERT_GT(stripe.size(), 30U) << "the doubled step breaks the half-pixel condition in most columns";

  cv::Mat filtered;
  cv::medianBlur(cv::Mat(150, 300, CV_8U, const_cast<std::uint8_t*>(picture.bytes.data())), filtered, 3);
  // Otsu from a sample of the columns, as the stage takes it; OpenCV's on the same sample.
  cv::Mat sample;
  for (int u = 1; u < filtered.cols; u += 3)
  {
    const cv::Mat column = filtered.col(u);
    if (sample.empty())
      sample = column.clone();
    else
      cv::hconcat(sample, column, sample);
  }
  cv::Mat ignored;
  const double threshold = cv::threshold(sample, ignored, 0.0, 255.0, cv::THRESH_OTSU);

  std::size_t next = 0;
  int compared = 0;
  for (int u = 4; u < 296; ++u)
  {
    const Letter expected = byTheLetter(filtered, threshold, u);
    while (next < stripe.size() && stripe.cell[next] < u)
      ++next;
    const bool kept = next < stripe.size() && stripe.cell[next] == u;
    if (expected.at_limit)
      continue;
    ASSERT_EQ(kept, expected.kept) << "column " << u;
    if (!kept)
      continue;
    EXPECT_NEAR(stripe.u[next], expected.u, 1e-4);
    EXPECT_NEAR(stripe.v[next], expected.v, 1e-4);
    ++compared;
  }
  EXPECT_GT(compared, 30);
}
TEST(LiteralReading, AStripeOfOneRowHasAWidth)
{
  Picture picture;
  picture.width = 60;
  picture.height = 40;
  picture.bytes.assign(60 * 40, 10);
  for (int u = 0; u < 60; ++u)
    picture.bytes[static_cast<std::size_t>(20 * 60 + u)] = static_cast<std::uint8_t>(200 + u % 3);
  StripeParams params = test_support::paramsOf("pca");
  params.taylor = "literal";
  params.median_size_px = 0;
  params.min_stripe_width_px = 0.0;
  const Stripe stripe = test_support::extract(params, picture);
  ASSERT_GT(stripe.size(), 30U);
  for (const float width : stripe.width)
    EXPECT_GT(width, 0.0F);
}
}  // namespace
}  // namespace weld_profiler
