#pragma once

#include <Eigen/Dense>

namespace weld_profiler
{
/// One cubic polynomial through noisy points by least squares, with the covariance of what it predicts.
class LeastSquaresCubic
{
public:
  /// Begins a fit whose x lie in [middle - scale, middle + scale].
  void begin(double middle, double scale);
  void add(double x, double y);
  /// Solves for the points added. At least four, at different x.
  void solve();

  double at(double x) const { return basis(x).dot(coefficients_); }
  double slope(double x) const;
  /// 1-sigma of at(x), for points that scatter by 1.
  double sigmaGain(double x) const;

private:
  Eigen::Vector4d basis(double x) const;

  double middle_ = 0.0;
  double scale_ = 1.0;
  Eigen::Matrix4d normal_ = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right_ = Eigen::Vector4d::Zero();
  Eigen::Vector4d coefficients_ = Eigen::Vector4d::Zero();
  Eigen::Matrix4d covariance_ = Eigen::Matrix4d::Zero();
};
}  // namespace weld_profiler
