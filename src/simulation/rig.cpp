#include "simulation/rig.h"

#include <cmath>

#include <Eigen/Geometry>

namespace weld_profiler
{
namespace simulation
{
namespace
{
constexpr double kRadPerDeg = 0.017453292519943295;

Eigen::Vector3d vector(const std::array<double, 3>& values)
{
  return { values[0], values[1], values[2] };
}

std::array<double, 3> rolled(const std::array<double, 3>& values, double roll, double sign)
{
  const Eigen::Vector3d turned =
      sign * (Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitZ()) * vector(values)).normalized();
  return { { turned.x(), turned.y(), turned.z() } };
}

Calibration trueCalibration(const SceneParams& scene)
{
  Calibration result = scene.calibration;
  const double roll = scene.rig_roll_deg * kRadPerDeg;
  result.laser_plane.normal = rolled(scene.calibration.laser_plane.normal, roll, 1.0);
  result.stage.axis = rolled(scene.calibration.stage.axis, roll, scene.part_moves ? -1.0 : 1.0);
  return result;
}
}  // namespace

Rig::Rig(const SceneParams& scene, const Motion& motion)
  : calibration_(trueCalibration(scene)), camera_(scene.calibration.camera), motion_(motion)
{
  const Eigen::Vector3d optical = Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d y = vector(calibration_.stage.axis);
  const Eigen::Vector3d z = -(optical - optical.dot(y) * y).normalized();
  scan_axes_ << y.cross(z), y, z;
  normal_ = vector(calibration_.laser_plane.normal);
  origin_ = optical * (calibration_.laser_plane.distance / normal_.z());
  emitter_ = origin_ + scene.laser.standoff * (z - z.dot(normal_) * normal_).normalized();
  turning_ = scene.motion == "tf";
  turn_axis_ = vector(scene.tf_axis).normalized();
  const double duration = motion.duration();
  turn_rate_ = duration > 0.0 ? scene.tf_rotation_deg * kRadPerDeg / duration : 0.0;
}

RigPose Rig::pose(double seconds) const
{
  // p_camera = S p_fixed + o - s a, solved for p_fixed; S a = (0, 1, 0)
  const Eigen::Vector3d working_point(0.0, motion_.position(seconds), 0.0);
  RigPose pose;
  pose.rotation = scan_axes_.transpose();
  if (turning_)  // about the point where the optical axis meets the sheet, steadily: what slerp between poses gives
    pose.rotation = Eigen::AngleAxisd(turn_rate_ * (seconds - 0.5 * motion_.duration()), turn_axis_) * pose.rotation;
  pose.camera = working_point - pose.rotation * origin_;
  pose.emitter = pose.rotation * emitter_ + pose.camera;
  pose.sheet_normal = pose.rotation * normal_;
  pose.sheet_distance = calibration_.laser_plane.distance + pose.sheet_normal.dot(pose.camera);
  return pose;
}

Direction Rig::direction() const
{
  // the sheet's line in the image is perpendicular to the x-y part of its normal
  return std::abs(normal_.y()) >= std::abs(normal_.x()) ? Direction::AlongU : Direction::AlongV;
}
}  // namespace simulation
}  // namespace weld_profiler
