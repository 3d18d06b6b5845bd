#include "weld_path.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Dense>

#include "statistics.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kWindow = 8e-3;      // a place is told from samples this near [m]
constexpr double kStep = 2.5e-4;      // between the curve's points [m]
constexpr double kBendOn = 8e-3;      // beyond its ends [m]
constexpr double kYawPrior = 0.35;    // 1-sigma of tan(yaw)
constexpr double kBendPrior = 5.0;    // 1-sigma of half the curvature [1/m]
constexpr double kLeastSigma = 2e-5;  // of a sample: the middle of a bead wanders [m]
constexpr int kRounds = 4;

struct Parabola
{
  Eigen::Vector3d values = Eigen::Vector3d::Zero();  ///< x, dx/dy, half of the second derivative at the middle
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();

  /// 1-sigma of dx/dy at d from the middle.
  double slopeSigma(double d) const
  {
    return std::sqrt(std::max(0.0, covariance(1, 1) + 4.0 * d * covariance(1, 2) + 4.0 * d * d * covariance(2, 2)));
  }
};

Parabola fitAround(const std::vector<PathSample>& samples, double y)
{
  Parabola result;
  double scale = 0.0;
  for (int round = 0; round < kRounds; ++round)
  {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    normal(0, 0) = 1e-6;
    normal(1, 1) = 1.0 / square(kYawPrior);
    normal(2, 2) = 1.0 / square(kBendPrior);
    std::vector<double> residuals;
    for (const PathSample& sample : samples)
    {
      const double t = (sample.y - y) / kWindow;
      if (!(std::abs(t) < 1.0))
        continue;
      const Eigen::Vector3d row(1.0, sample.y - y, square(sample.y - y));
      const double residual = sample.x - row.dot(result.values);
      const double sigma = std::max(sample.sigma, kLeastSigma);
      residuals.push_back(residual);
      double weight = (1.0 - t * t) / square(sigma);
      if (round > 0)
        weight *= tukey(residual / std::max(scale, sigma));
      normal += weight * row * row.transpose();
      right += weight * sample.x * row;
    }
    if (round > 0)
      scale = std::max(robustSigma(std::move(residuals)), kLeastSigma);
    result.covariance = normal.inverse();
    result.values = result.covariance * right;
    if (round == 0)
      scale = 1e3;  // the first residuals are about nothing
  }
  return result;
}

double nearestSample(const std::vector<PathSample>& samples, double y)
{
  double best = samples.front().y;
  for (const PathSample& sample : samples)
  {
    if (std::abs(sample.y - y) < std::abs(best - y))
      best = sample.y;
  }
  return best;
}
/// The place at s on the straight line through two points.
WeldPathPoint between(const WeldPathPoint& a, const WeldPathPoint& b, double s)
{
  const double share = (s - a.s) / (b.s - a.s);
  WeldPathPoint point;
  point.s = s;
  point.x = a.x + share * (b.x - a.x);
  point.y = a.y + share * (b.y - a.y);
  point.yaw = a.yaw + std::min(std::max(share, 0.0), 1.0) * (b.yaw - a.yaw);
  return point;
}
}  // namespace

WeldPath::WeldPath(const std::vector<PathSample>& samples, double from_y, double to_y, double reach)
{
  first_y_ = from_y - std::ceil(reach / kStep) * kStep;
  const int count = static_cast<int>(std::ceil((to_y + reach - first_y_) / kStep)) + 1;
  double last_y = std::numeric_limits<double>::quiet_NaN();
  Parabola fit;
  for (int i = 0; i < count; ++i)
  {
    const double y = first_y_ + i * kStep;
    const double inside = std::min(std::max(y, from_y), to_y);
    const double known =
        std::abs(nearestSample(samples, inside) - inside) < 0.25 * kWindow ? inside : nearestSample(samples, inside);
    if (known != last_y)
      fit = fitAround(samples, known);
    last_y = known;
    WeldPathPoint point;
    // beyond its ends a weld bends on for a while, then goes straight
    const double bent = std::min(std::max(y, from_y - kBendOn), to_y + kBendOn);
    const double d = bent - known;
    const double slope = fit.values(1) + 2.0 * fit.values(2) * d;
    point.y = y;
    point.x = fit.values(0) + fit.values(1) * d + fit.values(2) * d * d + slope * (y - bent);
    point.yaw = -std::atan(slope);
    yaw_sigmas_.push_back(fit.slopeSigma(d));
    if (!points_.empty())
      point.s = points_.back().s + std::hypot(point.x - points_.back().x, kStep);
    points_.push_back(point);
  }
  spaceEvenly(from_y);
  fillFrames();
  length_ = sAt(to_y);
}

/// The same curve with points at equal steps in s, s = 0 at from_y.
void WeldPath::spaceEvenly(double from_y)
{
  const double zero = sAt(from_y);
  for (WeldPathPoint& point : points_)
    point.s -= zero;
  std::vector<WeldPathPoint> even;
  from_s_ = points_.front().s;
  const int count = static_cast<int>(std::floor((points_.back().s - from_s_) / kStep)) + 1;
  std::size_t i = 1;
  for (int k = 0; k < count; ++k)
  {
    const double s = from_s_ + k * kStep;
    while (i + 1 < points_.size() && points_[i].s < s)
      ++i;
    even.push_back(between(points_[i - 1], points_[i], s));
  }
  points_ = std::move(even);
}

double WeldPath::yawSigma(double y) const
{
  const double place = std::max(0.0, (y - first_y_) / kStep + 0.5);
  return yaw_sigmas_[std::min(static_cast<std::size_t>(place), yaw_sigmas_.size() - 1)];
}

double WeldPath::sAt(double y) const
{
  const auto after = std::upper_bound(points_.begin() + 1, points_.end() - 1, y,
                                      [](double value, const WeldPathPoint& point) { return value < point.y; });
  const WeldPathPoint& a = *(after - 1);
  return a.s + (y - a.y) / (after->y - a.y) * (after->s - a.s);
}

void WeldPath::fillFrames()
{
  for (std::size_t i = 0; i < points_.size(); ++i)
  {
    const WeldPathPoint& point = points_[i];
    const WeldPathPoint& before = points_[i > 0 ? i - 1 : i];
    const WeldPathPoint& after = points_[std::min(i + 1, points_.size() - 1)];
    frames_.push_back(Frame{ point.x, point.y, point.s, std::cos(point.yaw), std::sin(point.yaw),
                             (after.yaw - before.yaw) / (after.s - before.s) });
  }
}

std::size_t WeldPath::indexOf(double s) const
{
  const double place = std::max(0.0, (s - from_s_) / kStep + 0.5);
  return std::min(static_cast<std::size_t>(place), points_.size() - 1);
}

WeldPathPoint WeldPath::at(double s) const
{
  const std::size_t nearest = indexOf(s - 0.5 * kStep);
  const std::size_t i = std::min(nearest, points_.size() - 2);
  return between(points_[i], points_[i + 1], s);
}

PathPlace WeldPath::locate(double x, double y, double near_s) const
{
  constexpr int kMost = 8;  // looks; one is enough where the guess is good
  PathPlace place{ 0.0, near_s };
  for (int look = 0; look < kMost; ++look)
  {
    const Frame& frame = frames_[indexOf(place.s)];
    const double along = frame.cosine * (y - frame.y) - frame.sine * (x - frame.x);
    const double across = frame.cosine * (x - frame.x) + frame.sine * (y - frame.y);
    // at s + d the tangent has turned: along - d - across turn d = 0
    const double d = along / std::max(0.2, 1.0 + across * frame.turn);
    place.s = frame.s + d;
    place.q = across + 0.5 * d * d * frame.turn;
    const bool end = &frame == &frames_.front() || &frame == &frames_.back();
    if (std::abs(d) < 0.75 * kStep || end)
      break;
  }
  return place;
}

void WeldPath::locate(double near_s, Together& points) const
{
  const Frame& frame = frames_[indexOf(near_s)];
  double farthest = 0.0;
  for (std::size_t i = 0; i < kTogether; ++i)
  {
    const double along = frame.cosine * (points.y[i] - frame.y) - frame.sine * (points.x[i] - frame.x);
    const double across = frame.cosine * (points.x[i] - frame.x) + frame.sine * (points.y[i] - frame.y);
    const double d = along / std::max(0.2, 1.0 + across * frame.turn);
    points.s[i] = frame.s + d;
    points.q[i] = across + 0.5 * d * d * frame.turn;
    farthest = std::max(farthest, std::abs(d));
  }
  if (farthest < 0.75 * kStep)
    return;
  for (std::size_t i = 0; i < kTogether; ++i)
  {
    const PathPlace place = locate(points.x[i], points.y[i], near_s);
    points.q[i] = place.q, points.s[i] = place.s;
  }
}
}  // namespace weld
}  // namespace weld_profiler
