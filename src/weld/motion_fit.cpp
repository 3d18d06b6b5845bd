#include "motion_fit.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Dense>

#include "statistics.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr int kUnknowns = 6 + 3 * kCommonErrors;
using Unknowns = Eigen::Matrix<double, kUnknowns, 1>;
using Normal = Eigen::Matrix<double, kUnknowns, kUnknowns>;

// what is left of the profiler's systematic errors on a parent, and of a toe's place
constexpr std::array<double, kCommonErrors> kCommonSigma = { { 6e-7, 6e-7, 2e-5 } };  // [m]
constexpr double kFloor = 5e-7;                                                       // of the scatter [m]
constexpr int kAbsoluteSteps = 25, kTukeySteps = 15;

class Fit
{
public:
  Fit(const std::vector<MotionObservation>& observations, const Vector6d& so_far, const Matrix6d& knowledge)
    : observations_(observations), residuals_(observations.size(), 0.0), weights_(observations.size(), 0.0)
  {
    prior_.setZero();
    prior_.topLeftCorner<6, 6>() = knowledge;
    pull_.setZero();
    pull_.head<6>() = knowledge * so_far;
    for (int i = 0; i < 3 * kCommonErrors; ++i)
      prior_(6 + i, 6 + i) = 1.0 / square(kCommonSigma[static_cast<std::size_t>(i / 3)]);
    for (std::size_t i = 0; i < observations.size(); ++i)
      residuals_[i] = observations[i].distance;
  }

  MotionStep operator()()
  {
    scatter_ = kFloor;
    for (int step = 0; step < kAbsoluteSteps; ++step)
    {
      weigh([this](std::size_t i, double sigma) { return 1.0 / (sigma * std::max(sigma, std::abs(residuals_[i]))); });
      solve();
    }
    for (int step = 0; step < kTukeySteps; ++step)
    {
      scatter_ = std::max(kFloor, robustSigma(plainResiduals()));
      weigh([this](std::size_t i, double sigma) { return tukey(residuals_[i] / sigma) / square(sigma); });
      solve();
    }
    return result();
  }

private:
  template <class Weight>
  void weigh(Weight&& weight)
  {
    for (std::size_t i = 0; i < observations_.size(); ++i)
      weights_[i] = weight(i, observations_[i].sigma > 0.0 ? observations_[i].sigma : scatter_);
  }

  static Unknowns row(const MotionObservation& observation)
  {
    Unknowns row = Unknowns::Zero();
    row.head<6>() = observation.jacobian;
    row.segment<3>(6 + 3 * static_cast<int>(observation.common)) = observation.shape;
    return row;
  }

  void solve()
  {
    normal_ = prior_;
    Unknowns right = -pull_;
    for (std::size_t i = 0; i < observations_.size(); ++i)
    {
      const Unknowns j = row(observations_[i]);
      normal_ += weights_[i] * j * j.transpose();
      right -= weights_[i] * observations_[i].distance * j;
    }
    // units differ by orders of magnitude: metres against radians times metres
    const Unknowns scale = normal_.diagonal().cwiseSqrt().cwiseInverse();
    const Normal scaled = scale.asDiagonal() * normal_ * scale.asDiagonal();
    solution_ = scale.asDiagonal() * scaled.ldlt().solve(scale.asDiagonal() * right);
    for (std::size_t i = 0; i < observations_.size(); ++i)
      residuals_[i] = observations_[i].distance + row(observations_[i]).dot(solution_);
  }

  std::vector<double> plainResiduals() const
  {
    std::vector<double> plain;
    for (std::size_t i = 0; i < observations_.size(); ++i)
      if (!(observations_[i].sigma > 0.0))
        plain.push_back(residuals_[i]);
    return plain;
  }

  MotionStep result() const
  {
    MotionStep step;
    step.motion = solution_.head<6>();
    const Unknowns scale = normal_.diagonal().cwiseSqrt().cwiseInverse();
    const Normal scaled = scale.asDiagonal() * normal_ * scale.asDiagonal();
    const Normal inverse = scaled.ldlt().solve(Normal::Identity());
    step.covariance = (scale.asDiagonal() * inverse * scale.asDiagonal()).eval().topLeftCorner<6, 6>();
    step.scatter = scatter_;
    step.residuals = residuals_;
    double sum = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < observations_.size(); ++i)
    {
      if (observations_[i].sigma > 0.0 || !(weights_[i] > 0.0))
        continue;
      sum += square(residuals_[i]);
      ++count;
    }
    step.rms = count > 0 ? std::sqrt(sum / count) : 0.0;
    return step;
  }

  const std::vector<MotionObservation>& observations_;
  std::vector<double> residuals_, weights_;
  Normal prior_, normal_;
  Unknowns pull_, solution_;
  double scatter_ = 0.0;
};
}  // namespace

MotionStep fitMotion(const std::vector<MotionObservation>& observations, const Vector6d& so_far,
                     const Matrix6d& knowledge)
{
  return Fit(observations, so_far, knowledge)();
}

Eigen::Isometry3d motionOf(const Vector6d& step, const Eigen::Vector3d& about)
{
  const Eigen::Vector3d turn = step.tail<3>();
  const double angle = turn.norm();
  const Eigen::Matrix3d rotation =
      angle > 0.0 ? Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix() : Eigen::Matrix3d::Identity();
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.linear() = rotation;
  motion.translation() = about + step.head<3>() - rotation * about;
  return motion;
}

Vector6d stepOf(const Eigen::Isometry3d& motion, const Eigen::Vector3d& about)
{
  const Eigen::AngleAxisd turn(motion.linear());
  Vector6d step;
  step << motion * about - about, turn.angle() * turn.axis();
  return step;
}
}  // namespace weld
}  // namespace weld_profiler
