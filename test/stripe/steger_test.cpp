// Steger's method in a band around the stripe against the same on the whole frame, smoothed by OpenCV.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "support/extract.h"

namespace weld_profiler
{
namespace
{
TEST(Steger, InABandIsStegerOnTheWholeFrame)
{
  constexpr double kSigma = 2.31;
  test_support::StripePicture scene;
  scene.width = 400;
  scene.height = 160;
  scene.snr = 50.0;
  scene.row = [](double u) { return 100.3 + 0.03 * u - 45.0 * std::exp(-0.5 * std::pow((u - 200.0) / 45.0, 2.0)); };
  const test_support::Picture picture = render(scene);
  StripeParams params = test_support::paramsOf("steger");
  params.hessian_sigma_px = kSigma;
  const Stripe stripe = test_support::extract(params, picture);
  ASSERT_EQ(stripe.size(), 400U);

  cv::Mat image;
  cv::Mat(160, 400, CV_8U, const_cast<std::uint8_t*>(picture.bytes.data())).convertTo(image, CV_64F);
  const int reach = static_cast<int>(std::ceil(4.0 * kSigma));
  cv::Mat smooth(1, 2 * reach + 1, CV_64F), slope = smooth.clone(), bend = smooth.clone();
  double sum = 0.0, second = 0.0, fourth = 0.0;
  for (int x = -reach; x <= reach; ++x)
    sum += smooth.at<double>(x + reach) = std::exp(-0.5 * x * x / (kSigma * kSigma));
  smooth /= sum;
  for (int x = -reach; x <= reach; ++x)
  {
    second += smooth.at<double>(x + reach) * x * x;
    fourth += smooth.at<double>(x + reach) * x * x * x * x;
  }
  for (int x = -reach; x <= reach; ++x)
  {
    slope.at<double>(x + reach) = smooth.at<double>(x + reach) * x / second;
    bend.at<double>(x + reach) = 2.0 * smooth.at<double>(x + reach) * (x * x - second) / (fourth - second * second);
  }
  cv::Mat r[5];
  const cv::Mat* const kernels[5][2] = {
    { &slope, &smooth }, { &smooth, &slope }, { &bend, &smooth }, { &slope, &slope }, { &smooth, &bend }
  };
  for (int i = 0; i < 5; ++i)
    cv::sepFilter2D(image, r[i], CV_64F, *kernels[i][0], *kernels[i][1]);

  int compared = 0;
  for (std::size_t i = static_cast<std::size_t>(reach); i + static_cast<std::size_t>(reach) < stripe.size(); ++i)
  {
    // Every pixel of the column that satisfies Steger's condition, or nearly so half-way between two; the nearest to
    // what was found.
    const int u = stripe.cell[i];
    double nearest = 1e9;
    for (int v = reach; v < picture.height - reach; ++v)
    {
      const auto at = [&](int which) { return r[which].at<double>(v, u); };
      Eigen::Matrix2d hessian;
      hessian << at(2), at(3), at(3), at(4);
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(hessian);
      const Eigen::Vector2d n = solver.eigenvectors().col(0);
      const double t = -(n.x() * at(0) + n.y() * at(1)) / solver.eigenvalues()[0];
      if (solver.eigenvalues()[0] >= 0.0 || std::abs(t) > 0.55)
        continue;
      nearest = std::min(nearest, std::hypot(u + t * n.x() - stripe.u[i], v + t * n.y() - stripe.v[i]));
    }
    EXPECT_LT(nearest, 1e-4) << "cell " << u;
    ++compared;
  }
  EXPECT_GT(compared, 350);
}
}  // namespace
}  // namespace weld_profiler
