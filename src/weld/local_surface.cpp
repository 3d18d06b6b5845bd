#include "local_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Dense>

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr int kLeastPoints = 6;
constexpr double kLopsided = 0.5;      // of the radius: points whose middle lies further off are about another place
constexpr double kLeastSpread = 0.08;  // of the radius, 1-sigma across the narrowest direction
constexpr double kBendHeld = 1e-3;     // of the weights' sum: a full circle of points determines the bend with 2e-2
}  // namespace

/// Of weighted points about a place, lengths in radii.
struct LocalSurface::Sums
{
  double s = 0.0, q = 0.0;  ///< the place [m]
  int count = 0;
  double nearest = std::numeric_limits<double>::infinity();  ///< squared
  double w = 0.0, ws = 0.0, wq = 0.0, wss = 0.0, wsq = 0.0, wqq = 0.0, wsqq = 0.0, wqqq = 0.0, wqqqq = 0.0;
  double wz = 0.0, wsz = 0.0, wqz = 0.0, wqqz = 0.0;

  /// Whether the points lie around the place, in both directions.
  bool balanced() const
  {
    const double mean_s = ws / w, mean_q = wq / w;
    const double ss = wss / w - mean_s * mean_s, sq = wsq / w - mean_s * mean_q, qq = wqq / w - mean_q * mean_q;
    const double least = 0.5 * (ss + qq) - std::sqrt(0.25 * (ss - qq) * (ss - qq) + sq * sq);
    return std::hypot(mean_s, mean_q) <= kLopsided && least > kLeastSpread * kLeastSpread;
  }

  /// Height, slope along, slope across and half the bend across, of z [m] over lengths in radii.
  Eigen::Vector4d fit() const
  {
    Eigen::Matrix4d normal;
    normal << w, ws, wq, wqq, ws, wss, wsq, wsqq, wq, wsq, wqq, wqqq, wqq, wsqq, wqqq, wqqqq + kBendHeld * w;
    return normal.ldlt().solve(Eigen::Vector4d(wz, wsz, wqz, wqqz));
  }
};

LocalSurface::LocalSurface(const std::vector<HeightPoint>& points, double radius, double reach)
  : radius_(radius), reach_(reach)
{
  if (points.empty())
    return;
  double to_s = points.front().s, to_q = points.front().q;
  from_s_ = to_s, from_q_ = to_q;
  for (const HeightPoint& point : points)
  {
    from_s_ = std::min(from_s_, point.s), to_s = std::max(to_s, point.s);
    from_q_ = std::min(from_q_, point.q), to_q = std::max(to_q, point.q);
  }
  bins_s_ = static_cast<int>((to_s - from_s_) / radius) + 1;
  bins_q_ = static_cast<int>((to_q - from_q_) / radius) + 1;
  const auto bin = [this](const HeightPoint& point)
  {
    const int i = static_cast<int>((point.s - from_s_) / radius_), j = static_cast<int>((point.q - from_q_) / radius_);
    return static_cast<std::size_t>(i) * static_cast<std::size_t>(bins_q_) + static_cast<std::size_t>(j);
  };
  points_.fill(static_cast<std::size_t>(bins_s_) * static_cast<std::size_t>(bins_q_),
               [&](const auto& put)
               {
                 for (const HeightPoint& point : points)
                   put(bin(point), point);
               });
}

void LocalSurface::gather(const HeightPoint* from, const HeightPoint* to, Sums& sums) const
{
  const double scale = 1.0 / radius_;
  for (const HeightPoint* point = from; point != to; ++point)
  {
    const double s = (point->s - sums.s) * scale, q = (point->q - sums.q) * scale, z = point->z;
    const double squared = s * s + q * q;
    const double t = 1.0 - squared;
    if (!(t > 0.0))
      continue;
    const double w = t * t, wq = w * q, wqq = wq * q, ws = w * s;
    ++sums.count;
    sums.nearest = std::min(sums.nearest, squared);
    sums.w += w, sums.ws += ws, sums.wq += wq;
    sums.wss += ws * s, sums.wsq += ws * q, sums.wqq += wqq;
    sums.wsqq += wqq * s, sums.wqqq += wqq * q, sums.wqqqq += wqq * q * q;
    sums.wz += w * z, sums.wsz += ws * z, sums.wqz += wq * z, sums.wqqz += wqq * z;
  }
}

HeightSample LocalSurface::at(double s, double q) const
{
  Sums sums;
  sums.s = s, sums.q = q;
  const int i = static_cast<int>(std::floor((s - from_s_) / radius_));
  const int j = static_cast<int>(std::floor((q - from_q_) / radius_));
  const int from = std::max(j - 1, 0), to = std::min(j + 1, bins_q_ - 1);
  for (int row = std::max(i - 1, 0); row <= std::min(i + 1, bins_s_ - 1) && from <= to; ++row)
  {
    const std::size_t begin = static_cast<std::size_t>(row) * static_cast<std::size_t>(bins_q_);
    gather(points_.begin(begin + static_cast<std::size_t>(from)), points_.end(begin + static_cast<std::size_t>(to)),
           sums);
  }
  if (sums.count < kLeastPoints || std::sqrt(sums.nearest) * radius_ > reach_ || !sums.balanced())
    return {};
  const Eigen::Vector4d fit = sums.fit();
  return { true, fit(0), fit(1) / radius_, fit(2) / radius_ };
}
}  // namespace weld
}  // namespace weld_profiler
