#include "weld_profiler/geometry/scan_frame.h"

#include "weld_profiler/geometry/calibration_file.h"

namespace weld_profiler
{
ScanFrame::ScanFrame(const Calibration& calibration)
{
  Calibration checked = calibration;
  validateCalibration(checked, "calibration");
  const Eigen::Vector3d optical = Eigen::Vector3d::UnitZ();
  axis_ = Eigen::Map<const Eigen::Vector3d>(checked.stage.axis.data());
  const Eigen::Vector3d up = -(optical - optical.dot(axis_) * axis_).normalized();
  rotation_.col(0) = axis_.cross(up);
  rotation_.col(1) = axis_;
  rotation_.col(2) = up;
  origin_ = optical * (checked.laser_plane.distance / checked.laser_plane.normal[2]);
}

Eigen::Isometry3d ScanFrame::cameraTScan(double stage) const
{
  Eigen::Isometry3d camera_T_scan = Eigen::Isometry3d::Identity();
  camera_T_scan.linear() = rotation_;
  camera_T_scan.translation() = origin_ - stage * axis_;
  return camera_T_scan;
}

Eigen::Isometry3d ScanFrame::scanTCamera(double stage) const
{
  return cameraTScan(stage).inverse();
}
}  // namespace weld_profiler
