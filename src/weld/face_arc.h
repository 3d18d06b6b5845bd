#pragma once

#include <vector>

#include <Eigen/Core>

namespace weld_profiler
{
namespace weld
{
/// A point of a section and what it weighs in a fit.
struct FacePoint
{
  Eigen::Vector2d place = Eigen::Vector2d::Zero();
  double weight = 1.0;
};

/// A circular arc (or straight line) through points that were chosen beforehand: n = a + b p + c (p^2 + n^2), p along
/// the points' chord and n across it, which is a circle exactly and linear in a, b, c. Source: the algebraic fit of
/// V. Pratt, "Direct Least-Squares Fitting of Algebraic Surfaces", SIGGRAPH 1987, with the chord's direction in place
/// of his constraint: for an arc that turns by less than a right angle the two agree.
class FaceArc
{
public:
  /// At least four points, in order along the face. Fitted robustly (Tukey's biweight).
  static FaceArc fit(const std::vector<FacePoint>& points);

  bool valid() const { return valid_; }
  double scatter() const { return scatter_; }  ///< of a point across the arc [m]

  /// Where the arc meets the line through `origin` along `direction` (unit), nearest to `origin`: the distance along
  /// it. Where a circle stays clear of it, its tangent at the points' first is taken. NaN where there is none.
  double meet(const Eigen::Vector2d& origin, const Eigen::Vector2d& direction) const;

  /// Direction of travel along the points, at the arc's place nearest to `place` [rad].
  double direction(const Eigen::Vector2d& place) const;

  /// 1-sigma across the arc at a place on or beside it, for points with this error energy.
  /// @param energy  variance of a point times the number of neighbours that share an error [m^2].
  double sigmaAcross(const Eigen::Vector2d& place, double energy) const;
  double sigmaDirection(const Eigen::Vector2d& place, double energy) const;  ///< [rad]

  /// Height of the arc over a place: solves for the second coordinate; NaN where there is none.
  double heightAt(double first) const;

private:
  bool layFrame(const std::vector<FacePoint>& points);
  bool regress(const std::vector<Eigen::Vector2d>& places, const std::vector<double>& weights);
  void tellShape(const std::vector<Eigen::Vector2d>& places, std::vector<double> weights);
  Eigen::Vector2d local(const Eigen::Vector2d& place) const;
  double bendAt(const Eigen::Vector2d& origin, const Eigen::Vector2d& direction, double curvature) const;

  bool valid_ = false;
  Eigen::Vector2d middle_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d along_ = Eigen::Vector2d::UnitX();
  Eigen::Vector2d across_ = Eigen::Vector2d::UnitY();
  Eigen::Vector3d values_ = Eigen::Vector3d::Zero();
  Eigen::Matrix3d shape_ = Eigen::Matrix3d::Zero();  ///< covariance for points of unit variance
  double scatter_ = 0.0;
};
}  // namespace weld
}  // namespace weld_profiler
