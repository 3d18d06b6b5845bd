#include "weld_profiler/geometry/camera_model.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <Eigen/LU>

#include "weld_profiler/core/errors.h"
#include "weld_profiler/geometry/calibration_file.h"

namespace weld_profiler
{
namespace
{
constexpr double kGridPitchPx = 8.0;
constexpr int kMostNewtonSteps = 50;
constexpr int kContinuationSteps = 64;
constexpr double kSolved = 1e-13;      // of a ray; 1e-9 is promised
constexpr double kGoodEnough = 1e-10;  // of a ray, after the Newton steps from the grid
}  // namespace

CameraModel::CameraModel(const CameraCalibration& calibration) : calibration_(calibration)
{
  validateCamera(calibration, "calibration");
  const CameraCalibration& c = calibration_;
  width_ = (c.roi_width > 0 ? c.roi_width : c.image_width) / c.binning_x;
  height_ = (c.roi_height > 0 ? c.roi_height : c.image_height) / c.binning_y;
  // A binned pixel's centre is the middle of the sensor pixels it merges, hence the half pixels.
  binning_ = { c.binning_x, c.binning_y };
  offset_ = { c.roi_x + 0.5 * (c.binning_x - 1), c.roi_y + 0.5 * (c.binning_y - 1) };
  buildGrid();
  chooseNewtonSteps();
}

Eigen::Vector2d CameraModel::distorted(double u, double v) const
{
  const Eigen::Vector2d sensor = binning_.cwiseProduct(Eigen::Vector2d(u, v)) + offset_;
  return { (sensor.x() - calibration_.cx) / calibration_.fx, (sensor.y() - calibration_.cy) / calibration_.fy };
}

Eigen::Vector2d CameraModel::project(const Eigen::Vector2d& ray) const
{
  Eigen::Matrix2d unused;
  const Eigen::Vector2d d = distort(ray, unused);
  const Eigen::Vector2d sensor(calibration_.fx * d.x() + calibration_.cx, calibration_.fy * d.y() + calibration_.cy);
  return (sensor - offset_).cwiseQuotient(binning_);
}

Eigen::Vector2d CameraModel::distort(const Eigen::Vector2d& ray, Eigen::Matrix2d& jacobian) const
{
  const auto& [k1, k2, p1, p2, k3] = calibration_.distortion;
  const double x = ray.x();
  const double y = ray.y();
  const double r2 = x * x + y * y;
  const double radial = 1.0 + r2 * (k1 + r2 * (k2 + r2 * k3));
  const double radial_slope = 2.0 * (k1 + r2 * (2.0 * k2 + r2 * 3.0 * k3));  // d radial / d r2, times 2
  jacobian(0, 0) = radial + x * x * radial_slope + 2.0 * p1 * y + 6.0 * p2 * x;
  jacobian(0, 1) = x * y * radial_slope + 2.0 * p1 * x + 2.0 * p2 * y;
  jacobian(1, 0) = jacobian(0, 1);
  jacobian(1, 1) = radial + y * y * radial_slope + 6.0 * p1 * y + 2.0 * p2 * x;
  return { x * radial + 2.0 * p1 * x * y + p2 * (r2 + 2.0 * x * x),
           y * radial + p1 * (r2 + 2.0 * y * y) + 2.0 * p2 * x * y };
}

/// One Newton step toward distort(ray) = target. False where the image folds (or NaN came in).
bool CameraModel::newtonStep(const Eigen::Vector2d& target, Ray& ray) const
{
  Eigen::Matrix2d jacobian;
  const Eigen::Vector2d missing = target - distort(ray.direction, jacobian);
  const double determinant = jacobian.determinant();
  if (!(determinant > 1e-6))
    return false;
  Eigen::Matrix2d inverse;
  inverse << jacobian(1, 1), -jacobian(0, 1), -jacobian(1, 0), jacobian(0, 0);
  inverse /= determinant;
  ray.direction += inverse * missing;
  ray.slope.col(0) = inverse.col(0) * (binning_.x() / calibration_.fx);
  ray.slope.col(1) = inverse.col(1) * (binning_.y() / calibration_.fy);
  return true;
}

bool CameraModel::solve(const Eigen::Vector2d& target, Ray& ray) const
{
  for (int step = 0; step < kMostNewtonSteps; ++step)
  {
    const Eigen::Vector2d before = ray.direction;
    if (!newtonStep(target, ray))
      return false;
    if ((ray.direction - before).norm() <= kSolved * (1.0 + before.norm()))
      return true;
  }
  return false;
}

void CameraModel::buildGrid()
{
  grid_columns_ = static_cast<int>(std::ceil(width_ / kGridPitchPx)) + 1;
  grid_rows_ = static_cast<int>(std::ceil(height_ / kGridPitchPx)) + 1;
  cell_size_ = { static_cast<double>(width_) / (grid_columns_ - 1), static_cast<double>(height_) / (grid_rows_ - 1) };
  grid_.resize(static_cast<std::size_t>(grid_columns_) * static_cast<std::size_t>(grid_rows_));

  const auto refuse = [](double u, double v)
  {
    throw ConfigError("calibration: camera.distortion_coefficients fold the image, pixel (" + std::to_string(u) + ", " +
                      std::to_string(v) + ") has no ray; calibrate the camera again with points up to the corners");
  };
  // From the principal point outward to the first corner in small steps, so that Newton stays on the branch that a lens
  // has; from there each node starts at its neighbour.
  Ray ray{ Eigen::Vector2d::Zero(), Eigen::Matrix2d::Zero() };
  for (int step = 1; step <= kContinuationSteps; ++step)
    if (!solve(distorted(-0.5, -0.5) * step / kContinuationSteps, ray))
      refuse(-0.5, -0.5);
  for (int row = 0; row < grid_rows_; ++row)
  {
    if (row > 0)
      ray.direction = grid_[static_cast<std::size_t>(row - 1) * grid_columns_];
    for (int column = 0; column < grid_columns_; ++column)
    {
      const double u = column * cell_size_.x() - 0.5;
      const double v = row * cell_size_.y() - 0.5;
      if (!solve(distorted(u, v), ray))
        refuse(u, v);
      grid_[static_cast<std::size_t>(row) * grid_columns_ + column] = ray.direction;
    }
  }
}

/// The start is worst in the middle of a cell: there the steps must reach the full solution.
void CameraModel::chooseNewtonSteps()
{
  for (newton_steps_ = 1; newton_steps_ < kMostNewtonSteps; ++newton_steps_)
  {
    double worst = 0.0;
    for (int row = 0; row + 1 < grid_rows_; ++row)
      for (int column = 0; column + 1 < grid_columns_; ++column)
      {
        const double u = (column + 0.5) * cell_size_.x() - 0.5;
        const double v = (row + 0.5) * cell_size_.y() - 0.5;
        Ray quick = rayWithSlope(u, v);
        const Eigen::Vector2d direction = quick.direction;
        solve(distorted(u, v), quick);
        worst = std::max(worst, (quick.direction - direction).norm());
      }
    if (worst <= kGoodEnough)
      return;
  }
}

Eigen::Vector2d CameraModel::interpolated(double column, double row) const
{
  const int i = std::min(static_cast<int>(column), grid_columns_ - 2);
  const int j = std::min(static_cast<int>(row), grid_rows_ - 2);
  const double a = column - i;
  const double b = row - j;
  const Eigen::Vector2d* top = &grid_[static_cast<std::size_t>(j) * grid_columns_ + i];
  const Eigen::Vector2d* bottom = top + grid_columns_;
  return (1.0 - b) * ((1.0 - a) * top[0] + a * top[1]) + b * ((1.0 - a) * bottom[0] + a * bottom[1]);
}

CameraModel::Ray CameraModel::rayWithSlope(double u, double v) const
{
  const Eigen::Vector2d target = distorted(u, v);
  const double column = (u + 0.5) / cell_size_.x();
  const double row = (v + 0.5) / cell_size_.y();
  const double last_column = grid_columns_ - 1;
  const double last_row = grid_rows_ - 1;
  bool good = std::isfinite(column) && std::isfinite(row);
  if (!good)
    return Ray{ Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN()), Eigen::Matrix2d::Zero() };

  Ray ray{ interpolated(std::clamp(column, 0.0, last_column), std::clamp(row, 0.0, last_row)),
           Eigen::Matrix2d::Zero() };
  if (column >= 0.0 && column <= last_column && row >= 0.0 && row <= last_row)
    for (int step = 0; step < newton_steps_ && good; ++step)
      good = newtonStep(target, ray);
  else
    good = solve(target, ray);
  if (!good)
    ray.direction.setConstant(std::numeric_limits<double>::quiet_NaN());
  return ray;
}
}  // namespace weld_profiler
