#pragma once

#include <Eigen/Core>

#include "simulation/camera.h"
#include "simulation/motion.h"

namespace weld_profiler
{
namespace simulation
{
/// Where the rig is at one moment, in the fixed frame (the scan frame, which is fixed to the part).
struct RigPose
{
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();  ///< p_fixed = rotation p_camera + camera
  Eigen::Vector3d camera = Eigen::Vector3d::Zero();
  Eigen::Vector3d emitter = Eigen::Vector3d::Zero();        ///< where the laser sheet comes from
  Eigen::Vector3d sheet_normal = Eigen::Vector3d::UnitY();  ///< sheet: normal . p = distance
  double sheet_distance = 0.0;

  Eigen::Vector3d toCamera(const Eigen::Vector3d& fixed) const { return rotation.transpose() * (fixed - camera); }
};

/// Camera, laser plane and stage as one body that moves over the part.
class Rig
{
public:
  /// @throws ConfigError when plane, axis and optical axis make no scan frame.
  Rig(const SceneParams& scene, const Motion& motion);

  /// @param seconds  since the first frame.
  RigPose pose(double seconds) const;

  const Camera& camera() const { return camera_; }
  const Calibration& calibration() const { return calibration_; }
  Direction direction() const;

private:
  Calibration calibration_;  ///< the true one: rolled, axis turned
  Camera camera_;
  const Motion& motion_;
  bool turning_ = false;
  double turn_rate_ = 0.0;  ///< [rad/s]
  Eigen::Vector3d turn_axis_ = Eigen::Vector3d::UnitZ();
  Eigen::Matrix3d scan_axes_ = Eigen::Matrix3d::Identity();  ///< columns x, y, z of the scan frame, camera frame
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();         ///< o: optical axis meets laser plane, camera frame
  Eigen::Vector3d normal_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d emitter_ = Eigen::Vector3d::Zero();  ///< camera frame
};
}  // namespace simulation
}  // namespace weld_profiler
