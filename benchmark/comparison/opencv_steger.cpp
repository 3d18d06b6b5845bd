#include "comparison/opencv_steger.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

namespace weld_profiler
{
namespace comparison
{
namespace
{
constexpr double kReach = 4.0;        ///< of a kernel, in sigmas
constexpr double kWeakestPeak = 6.0;  ///< of a stripe [DN], the default of StripeParams::min_peak_counts
constexpr double kStripePerKernel = 1.155;

cv::Mat kernelOf(double sigma, int order)
{
  const int reach = static_cast<int>(std::ceil(kReach * sigma));
  cv::Mat kernel(2 * reach + 1, 1, CV_32F);
  for (int k = -reach; k <= reach; ++k)
  {
    const double g = std::exp(-0.5 * k * k / (sigma * sigma)) / (sigma * std::sqrt(2.0 * CV_PI));
    const double square = sigma * sigma;
    // filter2D correlates: the taps of the first derivative are turned round.
    const double tap = order == 0 ? g : order == 1 ? k / square * g : (k * k / square - 1.0) / square * g;
    kernel.at<float>(k + reach) = static_cast<float>(tap);
  }
  return kernel;
}
}  // namespace

OpencvSteger::OpencvSteger(double sigma)
  : smooth_(kernelOf(sigma, 0)), first_(kernelOf(sigma, 1)), second_(kernelOf(sigma, 2))
{
  // Second derivative on the middle of a stripe of the width this kernel is made for.
  const double stripe = sigma / kStripePerKernel;
  weakest_ = kWeakestPeak * stripe / std::pow(stripe * stripe + sigma * sigma, 1.5);
}

void OpencvSteger::process(const RawImage& image, Stripe& stripe)
{
  const int depth = image.encoding == "mono16" ? CV_16U : CV_8U;
  const cv::Mat frame(image.height, image.width, depth, const_cast<std::uint8_t*>(image.data), image.step);
  const auto filter = [&](const cv::Mat& along_u, const cv::Mat& along_v, cv::Mat& out)
  { cv::sepFilter2D(frame, out, CV_32F, along_u, along_v, cv::Point(-1, -1), 0.0, cv::BORDER_REPLICATE); };
  filter(first_, smooth_, x_);
  filter(smooth_, first_, y_);
  filter(second_, smooth_, xx_);
  filter(first_, first_, xy_);
  filter(smooth_, second_, yy_);
  findStrongest();
  stripe.clear();
  stripe.status = StripeStatus::NoStripe;
  stripe.direction = Direction::AlongU;
  const double weakest = weakest_ * (depth == CV_16U ? 257.0 : 1.0);
  for (int u = 0; u < image.width; ++u)
  {
    StripePoint point;
    if (strongest_.at<float>(u) < -weakest && centreAt(u, point))
      stripe.push_back(point);
  }
  if (!stripe.empty())
    stripe.status = StripeStatus::Ok;
}

/// In each column the pixel with the most negative second derivative.
void OpencvSteger::findStrongest()
{
  strongest_.create(1, xx_.cols, CV_32F);
  row_.create(1, xx_.cols, CV_32S);
  strongest_.setTo(0.0F);
  row_.setTo(0);
  auto* strongest = strongest_.ptr<float>();
  auto* rows = row_.ptr<int>();
  for (int v = 0; v < xx_.rows; ++v)
  {
    const auto* xx = xx_.ptr<float>(v);
    const auto* xy = xy_.ptr<float>(v);
    const auto* yy = yy_.ptr<float>(v);
    for (int u = 0; u < xx_.cols; ++u)
    {
      const float half = 0.5F * (xx[u] - yy[u]);
      const float eigenvalue = 0.5F * (xx[u] + yy[u]) - std::sqrt(half * half + xy[u] * xy[u]);
      rows[u] = eigenvalue < strongest[u] ? v : rows[u];
      strongest[u] = std::min(strongest[u], eigenvalue);
    }
  }
}

/// The Taylor step from the strongest pixel; where it leaves the pixel, from the pixel it leads to.
bool OpencvSteger::centreAt(int u, StripePoint& point) const
{
  int v = row_.at<int>(u);
  for (int i = 0; i < 4; ++i)
  {
    const double xx = xx_.at<float>(v, u), xy = xy_.at<float>(v, u), yy = yy_.at<float>(v, u);
    const double angle = 0.5 * std::atan2(2.0 * xy, xx - yy) + 0.5 * CV_PI;  // of the lower eigenvalue
    const double nx = std::cos(angle), ny = std::sin(angle);
    const double curvature = xx * nx * nx + 2.0 * xy * nx * ny + yy * ny * ny;
    if (!(curvature < 0.0))
      return false;
    const double t = -(x_.at<float>(v, u) * nx + y_.at<float>(v, u) * ny) / curvature;
    if (std::abs(t * nx) <= 0.6 && std::abs(t * ny) <= 0.6)
    {
      point.cell = static_cast<std::uint16_t>(u);
      point.u = static_cast<float>(u + t * nx);
      point.v = static_cast<float>(v + t * ny);
      point.normal_angle = static_cast<float>(std::remainder(angle, CV_PI));
      return true;
    }
    const int next = v + (t * ny > 0.0 ? 1 : -1);
    if (next < 0 || next >= xx_.rows)
      return false;
    v = next;
  }
  return false;
}
}  // namespace comparison
}  // namespace weld_profiler
