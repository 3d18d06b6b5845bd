#include "plain_svd.h"

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

namespace weld_profiler
{
namespace reference
{
namespace
{
constexpr int kTemplate = 3;  // reach of the 7x7 template

/// Smoothed frame's derivatives.
struct FrameDerivatives
{
  cv::Mat x, y, xx, xy, yy;
  int reach = 0;

  bool holds(int u, int v) const { return u >= reach && v >= reach && u < x.cols - reach && v < x.rows - reach; }
};

/// Gaussian, cut off at 4 sigma, with the moments of slope and curvature given back to the sampled kernel.
FrameDerivatives derivativesOf(const cv::Mat& gray8, double sigma)
{
  FrameDerivatives result;
  result.reach = static_cast<int>(std::ceil(4.0 * sigma));
  cv::Mat smooth = cv::getGaussianKernel(2 * result.reach + 1, sigma, CV_64F);
  cv::Mat first = smooth.clone();
  cv::Mat second = smooth.clone();
  double square = 0.0;
  double fourth = 0.0;
  for (int i = 0; i < smooth.rows; ++i)
  {
    const double x = i - result.reach;
    square += smooth.at<double>(i) * x * x;
    fourth += smooth.at<double>(i) * x * x * x * x;
  }
  for (int i = 0; i < smooth.rows; ++i)
  {
    const double x = i - result.reach;
    first.at<double>(i) *= x / square;
    second.at<double>(i) *= 2.0 * (x * x - square) / (fourth - square * square);
  }
  cv::Mat gray;
  gray8.convertTo(gray, CV_32F);
  cv::sepFilter2D(gray, result.x, CV_32F, first, smooth);
  cv::sepFilter2D(gray, result.y, CV_32F, smooth, first);
  cv::sepFilter2D(gray, result.xx, CV_32F, second, smooth);
  cv::sepFilter2D(gray, result.xy, CV_32F, first, first);
  cv::sepFilter2D(gray, result.yy, CV_32F, smooth, second);
  return result;
}

/// Eq. 4 over what Otsu's threshold leaves of the median-filtered frame; NaN where a column is dark.
std::vector<double> squaredCentroids(const cv::Mat& gray8)
{
  cv::Mat filtered;
  cv::Mat mask;
  cv::medianBlur(gray8, filtered, 3);
  cv::threshold(filtered, mask, 0.0, 255.0, cv::THRESH_BINARY | cv::THRESH_OTSU);
  std::vector<double> weight(static_cast<std::size_t>(gray8.cols), 0.0);
  std::vector<double> moment = weight;
  for (int v = 0; v < gray8.rows; ++v)
  {
    const auto* gray = gray8.ptr<unsigned char>(v);
    const auto* stripe = mask.ptr<unsigned char>(v);
    for (int u = 0; u < gray8.cols; ++u)
    {
      const double square = stripe[u] != 0 ? static_cast<double>(gray[u]) * gray[u] : 0.0;
      weight[static_cast<std::size_t>(u)] += square;
      moment[static_cast<std::size_t>(u)] += square * v;
    }
  }
  for (std::size_t u = 0; u < moment.size(); ++u)
    moment[u] = weight[u] > 0.0 ? moment[u] / weight[u] : std::numeric_limits<double>::quiet_NaN();
  return moment;
}

/// Of the line through the initial points of five columns either side. [rows a column]
double slopeAt(const std::vector<double>& rows, int u)
{
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  for (int i = std::max(0, u - 5); i <= std::min(static_cast<int>(rows.size()) - 1, u + 5); ++i)
  {
    const double row = rows[static_cast<std::size_t>(i)];
    if (std::isnan(row))
      continue;
    n += 1.0, x += i - u, y += row, xx += (i - u) * (i - u), xy += (i - u) * row;
  }
  const double spread = n * xx - x * x;
  return spread > 0.0 ? (n * xy - x * y) / spread : 0.0;
}

/// Eqs. 5-9. @return false: the template has no normal.
bool templateNormal(const cv::Mat& gray8, int u, int v, Eigen::Vector2d& normal)
{
  if (u < kTemplate || v < kTemplate || u >= gray8.cols - kTemplate || v >= gray8.rows - kTemplate)
    return false;
  Eigen::Matrix<double, 49, 3> p;
  for (int y = -kTemplate, i = 0; y <= kTemplate; ++y)
    for (int x = -kTemplate; x <= kTemplate; ++x, ++i)
      p.row(i) << x, y, gray8.at<unsigned char>(v + y, u + x);
  const Eigen::Vector2d moment = p.leftCols<2>().transpose() * p.col(2);
  if (!(moment.norm() > 1e-6 * p.squaredNorm()))
    return false;
  const Eigen::JacobiSVD<Eigen::Matrix<double, 49, 3>> svd(p, Eigen::ComputeFullV);
  normal = svd.matrixV().col(2).head<2>().normalized();
  return true;
}

/// Eqs. 10-11 about the block (centre.cell, round(initial row)), which moves to the pixel that holds the centre.
void step(const FrameDerivatives& d, const Eigen::Vector2d& n, double slope, PlainCentre& centre)
{
  const double initial = centre.v;
  const int u = centre.cell;
  int block = static_cast<int>(std::lround(initial));
  for (int move = 0, came_from = 0; move <= 2 && d.holds(u, block); ++move)
  {
    const double first = n.x() * d.x.at<float>(block, u) + n.y() * d.y.at<float>(block, u);
    const double second = n.x() * n.x() * d.xx.at<float>(block, u) + 2.0 * n.x() * n.y() * d.xy.at<float>(block, u) +
                          n.y() * n.y() * d.yy.at<float>(block, u);
    if (!(second < 0.0))
      return;
    const double t = -first / second;
    const int direction = t * n.y() > 0.0 ? 1 : -1;
    const bool swings = came_from == direction;
    if (std::abs(t) <= (swings ? 0.55 : 0.5))
    {
      if (std::abs(block + t * n.y() - slope * t * n.x() - initial) > 1.0)
        return;
      centre.u = u + t * n.x();
      centre.v = block + t * n.y();
      centre.defined = true;
      return;
    }
    if (swings)
      return;
    came_from = -direction;
    block += direction;
  }
}
}  // namespace

std::vector<PlainCentre> plainSvd(const cv::Mat& gray8, double hessian_sigma_px,
                                  const std::vector<double>& initial_rows)
{
  CV_Assert(gray8.type() == CV_8UC1 && hessian_sigma_px > 0.0);
  CV_Assert(initial_rows.empty() || initial_rows.size() == static_cast<std::size_t>(gray8.cols));
  const std::vector<double> own = squaredCentroids(gray8);
  const std::vector<double>& rows = initial_rows.empty() ? own : initial_rows;
  const FrameDerivatives derivatives = derivativesOf(gray8, hessian_sigma_px);
  std::vector<PlainCentre> centres;
  for (int u = 0; u < gray8.cols; ++u)
  {
    PlainCentre centre;
    centre.cell = u;
    centre.u = u;
    centre.v = rows[static_cast<std::size_t>(u)];
    if (std::isnan(centre.v))
      continue;
    Eigen::Vector2d normal;
    if (templateNormal(gray8, u, static_cast<int>(std::lround(centre.v)), normal))
      step(derivatives, normal, slopeAt(rows, u), centre);
    centres.push_back(centre);
  }
  return centres;
}
}  // namespace reference
}  // namespace weld_profiler
