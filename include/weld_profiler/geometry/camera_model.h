#pragma once

#include <vector>

#include <Eigen/Core>

#include "weld_profiler/geometry/calibration.h"

namespace weld_profiler
{
/// Pinhole with plumb_bob distortion; turns raw pixels into viewing rays. Immutable, thread safe.
///
/// Distortion: D. C. Brown, "Decentering distortion of lenses", 1966, in the form ROS and OpenCV use (k1 k2 p1 p2 k3).
/// Poor for: fisheye lenses.
class CameraModel
{
public:
  /// A viewing ray and how it turns as the pixel moves.
  struct Ray
  {
    Eigen::Vector2d direction;  ///< (x/z, y/z)
    Eigen::Matrix2d slope;      ///< d direction / d (u, v) [1/px]
  };

  /// @throws ConfigError naming the field, as validateCalibration does for the camera; also when the distortion folds
  ///         the image, so that a pixel has no ray.
  explicit CameraModel(const CameraCalibration& calibration);

  /// Ray (x/z, y/z) through a raw pixel of the calibrated image (after its ROI and binning).
  /// Starts from precomputed rays on a grid and takes one Newton step (two for a wide, strongly
  /// distorting lens): within 1e-9 of the full solution. Outside the
  /// image it is solved in full; NaN where the pixel has no ray or is itself not finite.
  Eigen::Vector2d ray(double u, double v) const { return rayWithSlope(u, v).direction; }
  Ray rayWithSlope(double u, double v) const;

  /// Raw pixel at which a ray (x/z, y/z) is seen, with distortion. The exact inverse of ray().
  Eigen::Vector2d project(const Eigen::Vector2d& ray) const;

  int width() const { return width_; }  ///< of the calibrated image (after ROI and binning) [px]
  int height() const { return height_; }

private:
  Eigen::Vector2d distorted(double u, double v) const;
  Eigen::Vector2d distort(const Eigen::Vector2d& ray, Eigen::Matrix2d& jacobian) const;
  bool newtonStep(const Eigen::Vector2d& target, Ray& ray) const;
  bool solve(const Eigen::Vector2d& target, Ray& ray) const;
  Eigen::Vector2d interpolated(double column, double row) const;
  void buildGrid();
  void chooseNewtonSteps();

  CameraCalibration calibration_;
  int width_ = 0;
  int height_ = 0;
  // image pixel -> sensor pixel, the one place that knows of ROI and binning: sensor = binning * image + offset
  Eigen::Vector2d binning_;
  Eigen::Vector2d offset_;
  // grid_[row * grid_columns_ + column] = ray at pixel (column * cell_size_.x() - 0.5, row * cell_size_.y() - 0.5)
  int grid_columns_ = 0;
  int grid_rows_ = 0;
  Eigen::Vector2d cell_size_;
  std::vector<Eigen::Vector2d> grid_;
  int newton_steps_ = 1;  ///< two for wide lenses with strong distortion, chosen so that 1e-9 holds
};
}  // namespace weld_profiler
