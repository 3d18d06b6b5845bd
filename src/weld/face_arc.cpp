#include "face_arc.h"

#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Dense>

#include "statistics.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
constexpr int kRounds = 4;
constexpr double kLeastScatter = 5e-7;  // [m]

/// The root of a x^2 + b x + c nearest to zero; NaN where there is none.
double smallRoot(double a, double b, double c)
{
  const double rest = b * b - 4.0 * a * c;
  if (!(rest >= 0.0))
    return kNothing;
  const double larger = -0.5 * (b + std::copysign(std::sqrt(rest), b));
  return larger != 0.0 ? c / larger : kNothing;
}

Eigen::Vector3d rowOf(const Eigen::Vector2d& local)
{
  return Eigen::Vector3d(1.0, local.x(), local.squaredNorm());
}

/// Sum of row rowT over the points.
Eigen::Matrix3d sumOver(const std::vector<Eigen::Vector2d>& places, const std::vector<double>& weights)
{
  double n = 0.0, p = 0.0, r = 0.0, pp = 0.0, pr = 0.0, rr = 0.0;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const double place = places[i].x(), square = places[i].squaredNorm();
    const double weighted = weights[i] * place, weighted_square = weights[i] * square;
    n += weights[i], p += weighted, r += weighted_square;
    pp += weighted * place, pr += weighted * square, rr += weighted_square * square;
  }
  Eigen::Matrix3d sum;
  sum << n, p, r, p, pp, pr, r, pr, rr;
  return sum;
}
}  // namespace

Eigen::Vector2d FaceArc::local(const Eigen::Vector2d& place) const
{
  const Eigen::Vector2d offset = place - middle_;
  return Eigen::Vector2d(along_.dot(offset), across_.dot(offset));
}

/// Lays the frame along the chord from the points' first third to their last.
bool FaceArc::layFrame(const std::vector<FacePoint>& points)
{
  const std::size_t third = std::max<std::size_t>(1, points.size() / 3);
  Eigen::Vector2d begin = Eigen::Vector2d::Zero(), end = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < third; ++i)
  {
    begin += points[i].place / static_cast<double>(third);
    end += points[points.size() - 1 - i].place / static_cast<double>(third);
  }
  if (!((end - begin).norm() > 0.0))
    return false;
  middle_ = 0.5 * (begin + end);
  along_ = (end - begin).normalized();
  across_ = Eigen::Vector2d(-along_.y(), along_.x());
  return true;
}

/// One weighted regression; false where the points do not determine an arc.
bool FaceArc::regress(const std::vector<Eigen::Vector2d>& places, const std::vector<double>& weights)
{
  const Eigen::Matrix3d inverse = sumOver(places, weights).inverse();
  if (!inverse.allFinite())
    return false;
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < places.size(); ++i)
    right += weights[i] * places[i].y() * rowOf(places[i]);
  values_ = inverse * right;
  return true;
}

/// The values' covariance for points of unit variance, with the weights of the last regression.
void FaceArc::tellShape(const std::vector<Eigen::Vector2d>& places, std::vector<double> weights)
{
  const Eigen::Matrix3d inverse = sumOver(places, weights).inverse();
  for (double& weight : weights)
    weight *= weight;
  shape_ = inverse * sumOver(places, weights) * inverse;
}

FaceArc FaceArc::fit(const std::vector<FacePoint>& points)
{
  FaceArc arc;
  if (points.size() < 4 || !arc.layFrame(points))
    return arc;
  std::vector<Eigen::Vector2d> places;
  places.reserve(points.size());
  for (const FacePoint& point : points)
    places.push_back(arc.local(point.place));
  std::vector<double> residuals(points.size(), 0.0), weights(points.size()), sorted;
  double scale = 1.0;
  for (int round = 0; round < kRounds; ++round)
  {
    for (std::size_t i = 0; i < points.size(); ++i)
      weights[i] = points[i].weight * tukey(residuals[i] / scale);
    if (!arc.regress(places, weights))
      return arc;
    for (std::size_t i = 0; i < points.size(); ++i)
      residuals[i] = places[i].y() - rowOf(places[i]).dot(arc.values_);
    sorted = residuals;
    scale = std::max(robustSigmaInPlace(sorted), kLeastScatter);
  }
  arc.tellShape(places, std::move(weights));
  arc.scatter_ = scale;
  arc.valid_ = arc.values_.allFinite();
  return arc;
}

double FaceArc::bendAt(const Eigen::Vector2d& origin, const Eigen::Vector2d& direction, double curvature) const
{
  const Eigen::Vector2d from = local(origin);
  const Eigen::Vector2d step(along_.dot(direction), across_.dot(direction));
  // a + b p + c |.|^2 - n = 0 at from + t step
  const double c = values_(0) + values_(1) * from.x() + curvature * from.squaredNorm() - from.y();
  const double b = values_(1) * step.x() + 2.0 * curvature * from.dot(step) - step.y();
  return smallRoot(curvature, b, c);
}

double FaceArc::meet(const Eigen::Vector2d& origin, const Eigen::Vector2d& direction) const
{
  const double distance = bendAt(origin, direction, values_(2));
  return std::isfinite(distance) ? distance : bendAt(origin, direction, 0.0);
}

double FaceArc::direction(const Eigen::Vector2d& place) const
{
  const Eigen::Vector2d at = local(place);
  const double slope = (values_(1) + 2.0 * values_(2) * at.x()) / (1.0 - 2.0 * values_(2) * at.y());
  return std::atan2(along_.y(), along_.x()) + std::atan(slope);
}

double FaceArc::sigmaAcross(const Eigen::Vector2d& place, double energy) const
{
  const Eigen::Vector3d row = rowOf(local(place));
  return std::sqrt(energy * row.dot(shape_ * row));
}

double FaceArc::sigmaDirection(const Eigen::Vector2d& place, double energy) const
{
  const Eigen::Vector3d row(0.0, 1.0, 2.0 * local(place).x());
  return std::sqrt(energy * row.dot(shape_ * row));
}

double FaceArc::heightAt(double first) const
{
  const double t = bendAt(Eigen::Vector2d(first, middle_.y()), Eigen::Vector2d::UnitY(), values_(2));
  return middle_.y() + t;
}
}  // namespace weld
}  // namespace weld_profiler
