#pragma once

#include <vector>

#include <Eigen/Core>

#include "weld_profiler/geometry/calibration.h"

namespace weld_profiler
{
/// Pinhole with plumb_bob distortion; turns raw pixels into viewing rays. Immutable, thread safe.
class CameraModel
{
public:
  /// @throws ConfigError naming the field, as validateCalibration does for the camera.
  explicit CameraModel(const CameraCalibration& calibration);

  /// Ray (x/z, y/z) through a raw pixel of the calibrated image (after its ROI and binning).
  /// Starts from precomputed rays on a grid and takes one Newton step: within 1e-9 of the full solution.
  Eigen::Vector2d ray(double u, double v) const;

  /// Raw pixel at which a ray (x/z, y/z) is seen, with distortion. The exact inverse of ray().
  Eigen::Vector2d project(const Eigen::Vector2d& ray) const;

  int width() const;   ///< of the calibrated image (after ROI and binning) [px]
  int height() const;

private:
  CameraCalibration calibration_;
  int grid_columns_ = 0;
  int grid_rows_ = 0;
  std::vector<Eigen::Vector2d> grid_;
};
}  // namespace weld_profiler
