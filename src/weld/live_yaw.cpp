#include "weld_profiler/weld/live_yaw.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

#include "statistics.h"

namespace weld_profiler
{
namespace
{
using weld::square;

constexpr double kWindow = 12e-3;     // told from middles this near [m]
constexpr double kApart = 5e-5;       // rows nearer than this are one [m]
constexpr double kAlike = 5e-4;       // middles nearer than this err alike [m]
constexpr double kTanPrior = 0.35;    // 1-sigma of tan(yaw), as of a path
constexpr double kBendPrior = 5.0;    // 1-sigma of half the curvature [1/m], as of a path
constexpr double kNoisePrior = 1e-4;  // 1-sigma of a middle while few rows tell it [m] ...
constexpr double kNoiseRows = 4.0;    // ... counting as so many rows
constexpr int kRounds = 5;

/// 1-sigma of a middle.
double noiseOf(std::vector<double> residuals)
{
  const auto rows = static_cast<double>(residuals.size());
  const double seen = weld::robustSigma(std::move(residuals));
  return std::sqrt((kNoiseRows * square(kNoisePrior) + rows * square(seen)) / (kNoiseRows + rows));
}
}  // namespace

void LiveYaw::add(double x, double y)
{
  if (!std::isfinite(x) || !std::isfinite(y))
    return;
  const double step = middles_.empty() ? INFINITY : std::abs(y - middles_.back().y);
  if (step < kApart)
    return;
  if (step > kWindow)
    middles_.clear();
  const auto far = [y](const Middle& middle) { return std::abs(middle.y - y) > kWindow; };
  middles_.erase(std::remove_if(middles_.begin(), middles_.end(), far), middles_.end());
  middles_.push_back({ x, y });
}

Quantity LiveYaw::at(double y) const
{
  if (middles_.empty())
    return { 0.0, kTanPrior };
  const auto far = [y](const Middle& middle) { return std::abs(middle.y - y) > kWindow; };
  std::vector<Middle> near;
  std::remove_copy_if(middles_.begin(), middles_.end(), std::back_inserter(near), far);
  const double span = near.size() > 1 ? std::abs(near.back().y - near.front().y) : 0.0;
  const double alike = span > 0.0 ? std::max(1.0, kAlike * static_cast<double>(near.size() - 1) / span) : 1.0;
  const Eigen::Vector3d prior(1e-6, 1.0 / square(kTanPrior), 1.0 / square(kBendPrior));
  Eigen::Vector3d fit = Eigen::Vector3d::Zero();  // x, dx/dy and half of the second derivative at y
  double noise = kNoisePrior, slope_sigma = kTanPrior;
  for (int round = 0; round < kRounds; ++round)
  {
    Eigen::Matrix3d normal = prior.asDiagonal();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    std::vector<double> residuals;
    for (const Middle& middle : near)
    {
      const Eigen::Vector3d row(1.0, middle.y - y, square(middle.y - y));
      const double departs = round == 0 ? 0.0 : middle.x - row.dot(fit);  // the first would be about nothing
      const double weight = weld::tukey(departs / noise) / (square(noise) * alike);
      normal += weight * row * row.transpose();
      right += weight * middle.x * row;
    }
    const Eigen::Matrix3d covariance = normal.inverse();
    fit = covariance * right;
    slope_sigma = std::sqrt(covariance(1, 1));
    residuals.reserve(near.size());
    for (const Middle& middle : near)
      residuals.push_back(middle.x - fit(0) - (middle.y - y) * (fit(1) + (middle.y - y) * fit(2)));
    noise = noiseOf(std::move(residuals));
  }
  return { -std::atan(fit(1)), slope_sigma / (1.0 + square(fit(1))) };
}
}  // namespace weld_profiler
