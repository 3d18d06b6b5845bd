#pragma once

#include <Eigen/Geometry>

#include "weld_profiler/geometry/calibration.h"

namespace weld_profiler
{
/// The frame of a scan, fixed to the part. With c the optical axis and a the stage axis: y = a,
/// z = -(c - (c.a)a) normalised (away from the part), x = y cross z; origin o = where the optical axis meets the laser
/// plane at stage position 0. Immutable, thread safe.
class ScanFrame
{
public:
  /// @throws ConfigError as validateCalibration.
  explicit ScanFrame(const Calibration& calibration);

  /// p_camera = R p_scan + o - s a.
  /// @param stage  stage position s [m].
  Eigen::Isometry3d cameraTScan(double stage) const;

  /// Maps camera points to the scan frame at stage position s [m]; the inverse of cameraTScan.
  Eigen::Isometry3d scanTCamera(double stage) const;

private:
  Eigen::Matrix3d rotation_;  ///< columns x, y, z of the scan frame in the camera frame
  Eigen::Vector3d origin_;
  Eigen::Vector3d axis_;
};
}  // namespace weld_profiler
