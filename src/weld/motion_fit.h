#pragma once

#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace weld_profiler
{
namespace weld
{
using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

/// What errs alike in all observations of a kind: by an offset, and by slopes over kCommonLength.
enum class CommonError
{
  LeftParent,
  RightParent,
  Toes
};
constexpr int kCommonErrors = 3;
constexpr double kCommonLength = 0.01;  // [m]

/// A distance between the scans that a small motion of the scan after would change.
struct MotionObservation
{
  Vector6d jacobian = Vector6d::Zero();  ///< of the distance to shift and rotation vector
  double distance = 0.0;                 ///< of the scan after from the one before [m]
  double sigma = 0.0;                    ///< 0 = told from the scatter of all that have none [m]
  CommonError common = CommonError::LeftParent;
  Eigen::Vector3d shape = Eigen::Vector3d::UnitX();  ///< how the common error enters: an offset and two slopes
};

/// A motion: shift and rotation vector.
struct MotionStep
{
  Vector6d motion = Vector6d::Zero();
  Matrix6d covariance = Matrix6d::Zero();
  double scatter = 0.0;           ///< of the observations without a sigma: their robust scale [m]
  double rms = 0.0;               ///< of those of them that count, after the step [m]
  std::vector<double> residuals;  ///< one an observation, after the step [m]
};

/// The step that lays the scan after on the one before, by robust least squares (sums of absolute values first, then
/// Tukey's biweight) with what is known beforehand.
/// @param so_far     the motion before the step.
/// @param knowledge  information matrix of the whole motion about none.
MotionStep fitMotion(const std::vector<MotionObservation>& observations, const Vector6d& so_far,
                     const Matrix6d& knowledge);

/// Shift and rotation vector about a place, and the motion that they make.
Eigen::Isometry3d motionOf(const Vector6d& step, const Eigen::Vector3d& about);
Vector6d stepOf(const Eigen::Isometry3d& motion, const Eigen::Vector3d& about);
}  // namespace weld
}  // namespace weld_profiler
