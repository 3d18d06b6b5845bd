#pragma once

#include <Eigen/Core>

#include "weld_profiler/geometry/calibration.h"

namespace weld_profiler
{
namespace simulation
{
/// The twin's own pinhole with plumb_bob distortion. Pixels are those of the region of interest.
class Camera
{
public:
  explicit Camera(const CameraCalibration& calibration);

  /// @param point  camera optical frame, in front of the camera [m].
  Eigen::Vector2d project(const Eigen::Vector3d& point) const;

  /// Ray (x/z, y/z, 1) seen by a pixel; the inverse of project() by iteration.
  Eigen::Vector3d ray(const Eigen::Vector2d& pixel) const;

  int width() const { return width_; }
  int height() const { return height_; }

private:
  CameraCalibration calibration_;
  int width_ = 0;
  int height_ = 0;
};
}  // namespace simulation
}  // namespace weld_profiler
