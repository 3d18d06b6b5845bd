#include <array>
#include <cmath>
#include <limits>
#include <sstream>

#include "weld_profiler/core/errors.h"
#include "weld_profiler/geometry/calibration_file.h"

namespace weld_profiler
{
namespace
{
using Vector = std::array<double, 3>;

constexpr double kSinFiveDegrees = 0.08715574274765817;
constexpr double kUnitTolerance = 1e-3;
constexpr double kAlreadyUnit = 1e-12;  // a second validation must not move the last digit
constexpr double kMost = std::numeric_limits<double>::max();

double dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

std::string text(const Vector& v)
{
  std::ostringstream out;
  out << "[" << v[0] << ", " << v[1] << ", " << v[2] << "]";
  return out.str();
}

template <class Value>
[[noreturn]] void refuse(const std::string& name, const Value& value, const std::string& remedy)
{
  std::ostringstream out;
  out << name << " is " << value << ", " << remedy;
  throw ConfigError(out.str());
}

/// @return the length it had; the vector is a unit vector afterwards.
double normalise(Vector& v, const std::string& name)
{
  const double length = std::sqrt(dot(v, v));
  if (!std::isfinite(length))
    refuse(name, text(v), "must be three finite numbers");
  if (length == 0.0)
    refuse(name, text(v), "its length is zero, must be a unit vector");
  if (!(std::abs(length - 1.0) <= kUnitTolerance))
  {
    std::ostringstream remedy;
    remedy << "its length is " << length << ", must be a unit vector within 1e-3: divide it by its length";
    refuse(name, text(v), remedy.str());
  }
  if (std::abs(length - 1.0) <= kAlreadyUnit)
    return 1.0;
  for (double& component : v)
    component /= length;
  return length;
}

void validateStage(StageCalibration& stage, const std::string& origin)
{
  if (stage.type == "rotary")
    refuse(origin + ": stage.type", "'rotary'", "a rotary stage is not supported yet, must be linear");
  if (stage.type != "linear")
    refuse(origin + ": stage.type", "'" + stage.type + "'", "must be linear");
  if (stage.joint.empty())
    refuse(origin + ": stage.joint", "empty", "must be a name in JointState");
  if (!(stage.metres_per_unit > 0.0 && stage.metres_per_unit <= kMost))
    refuse(origin + ": stage.metres_per_unit", stage.metres_per_unit,
           "must be greater than 0; for a stage that runs the other way reverse stage.axis");
  normalise(stage.axis, origin + ": stage.axis");
}

void validateAngles(const Calibration& calibration, const std::string& origin)
{
  const Vector& normal = calibration.laser_plane.normal;
  const Vector& axis = calibration.stage.axis;
  const Vector optical{ { 0.0, 0.0, 1.0 } };
  const double across = dot(normal, axis);
  if (!(std::abs(across) >= kSinFiveDegrees))
    refuse(origin + ": laser_plane.normal . stage.axis", across,
           "the stage moves within 5 deg of the laser plane and sweeps nothing; must be at least 0.0872 in size: check "
           "normal and axis");
  const double along = std::abs(dot(optical, axis));
  if (!(along <= std::sqrt(1.0 - kSinFiveDegrees * kSinFiveDegrees)))
    refuse(origin + ": stage.axis", text(axis),
           "within 5 deg of the optical axis [0, 0, 1], the scan frame is undefined; check the axis");
  const double meeting = calibration.laser_plane.distance / normal[2];
  if (!(meeting > 0.0 && meeting <= 1e3))
  {
    std::ostringstream value;
    value << text(normal) << " with laser_plane.distance " << calibration.laser_plane.distance;
    refuse(origin + ": laser_plane.normal", value.str(),
           "the optical axis must meet the plane in front of the camera within 1000 m; check both signs and the metre");
  }
}
}  // namespace

void validateCamera(const CameraCalibration& camera, const std::string& origin)
{
  const std::string name = origin + ": camera.";
  requireRange(name + "image_width", camera.image_width, 1, 65535, "px");
  requireRange(name + "image_height", camera.image_height, 1, 65535, "px");
  requireRange(name + "camera_matrix fx", camera.fx, 1.0, 1e7, "px");
  requireRange(name + "camera_matrix fy", camera.fy, 1.0, 1e7, "px");
  requireRange(name + "camera_matrix cx", camera.cx, -1e7, 1e7, "px");
  requireRange(name + "camera_matrix cy", camera.cy, -1e7, 1e7, "px");
  for (const double coefficient : camera.distortion)
    if (!std::isfinite(coefficient))
      refuse(name + "distortion_coefficients", coefficient, "must be finite numbers: k1 k2 p1 p2 k3");
  requireRange(name + "binning_x", camera.binning_x, 1, camera.image_width);
  requireRange(name + "binning_y", camera.binning_y, 1, camera.image_height);
  requireRange(name + "roi x_offset", camera.roi_x, 0, camera.image_width - 1, "px");
  requireRange(name + "roi y_offset", camera.roi_y, 0, camera.image_height - 1, "px");
  const int width_left = camera.image_width - camera.roi_x;
  const int height_left = camera.image_height - camera.roi_y;
  if (camera.roi_width != 0 || camera.roi_x != 0)
    requireRange(name + "roi width", camera.roi_width, camera.binning_x, width_left, "px");
  if (camera.roi_height != 0 || camera.roi_y != 0)
    requireRange(name + "roi height", camera.roi_height, camera.binning_y, height_left, "px");
}

void validateCalibration(Calibration& calibration, const std::string& origin)
{
  validateCamera(calibration.camera, origin);
  const double length = normalise(calibration.laser_plane.normal, origin + ": laser_plane.normal");
  if (!std::isfinite(calibration.laser_plane.distance))
    refuse(origin + ": laser_plane.distance", calibration.laser_plane.distance, "must be a finite number of metres");
  calibration.laser_plane.distance /= length;  // normal . p = distance is the same plane before and after
  validateStage(calibration.stage, origin);
  validateAngles(calibration, origin);
}
}  // namespace weld_profiler
