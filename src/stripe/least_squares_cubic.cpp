#include "least_squares_cubic.h"

#include <algorithm>
#include <cmath>

namespace weld_profiler
{
void LeastSquaresCubic::begin(double middle, double scale)
{
  middle_ = middle;
  scale_ = scale;
  normal_.setZero();
  right_.setZero();
}

void LeastSquaresCubic::add(double x, double y)
{
  const Eigen::Vector4d row = basis(x);
  normal_ += row * row.transpose();
  right_ += row * y;
}

void LeastSquaresCubic::solve()
{
  const Eigen::LDLT<Eigen::Matrix4d> solver(normal_);
  coefficients_ = solver.solve(right_);
  covariance_ = solver.solve(Eigen::Matrix4d::Identity());
}

double LeastSquaresCubic::slope(double x) const
{
  const double t = (x - middle_) / scale_;
  return (coefficients_[1] + 2.0 * coefficients_[2] * t + 3.0 * coefficients_[3] * t * t) / scale_;
}

double LeastSquaresCubic::sigmaGain(double x) const
{
  const Eigen::Vector4d row = basis(x);
  return std::sqrt(std::max(0.0, row.dot(covariance_ * row)));
}

Eigen::Vector4d LeastSquaresCubic::basis(double x) const
{
  const double t = (x - middle_) / scale_;
  return { 1.0, t, t * t, t * t * t };
}
}  // namespace weld_profiler
