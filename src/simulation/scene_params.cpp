#include "weld_profiler/simulation/scene_params.h"

#include <cmath>

#include "simulation/part_checks.h"
#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
namespace
{
const std::vector<std::string> kMotions{ "stage", "tf" };
const std::vector<std::string> kEncodings{ "mono8", "mono16", "bayer_rggb8", "bgr8" };
constexpr double kQuantisation = 1.0 / 12.0;  // variance of rounding [DN^2]
constexpr double kFullScale = 255.0;          // [DN of 8 bit]
constexpr double kSinFiveDegrees = 0.08715574274765817;

void requireUnit(const std::string& name, const std::array<double, 3>& values)
{
  const double length = std::sqrt(values[0] * values[0] + values[1] * values[1] + values[2] * values[2]);
  requireRange(name + "'s length", length, 0.999, 1.001, "(a unit vector)");
}

double dot(const std::array<double, 3>& a, const std::array<double, 3>& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

void checkTime(const SceneParams& scene)
{
  requireRange("start_time", scene.start_time, 0.0, 4e9, "s");
  requireRange("frame_rate", scene.frame_rate, 0.1, 1000.0, "1/s");
  requireRange("frame_count", scene.frame_count, 0, 100000);
  requireRange("scan_length", scene.scan_length, 1e-5, 2.0, "m");
  requireRange("exposure", scene.exposure, 0.0, 1.0 / scene.frame_rate, "s (at most a frame's period)");
}

void checkMotion(const SceneParams& scene)
{
  requireOneOf("motion", scene.motion, kMotions);
  requireRange("start_position", scene.start_position, -10.0, 10.0, "m");
  requireRange("part_start", scene.part_start, -2.0, 2.0, "m");
  requireRange("speed", scene.speed, -1.0, 1.0, "m/s");
  if (std::abs(scene.speed) < 1e-5)
    throw ConfigError("speed is " + std::to_string(scene.speed) + ", must be at least 1e-05 m/s either way");
  const double frames = scene.scan_length / std::abs(scene.speed) * scene.frame_rate;
  if (scene.frame_count == 0 && frames > 100000.0)
    throw ConfigError("speed is " + std::to_string(scene.speed) +
                      " m/s, the scan would have more than 100000 frames: "
                      "set frame_count");
  requireRange("speed_variation", scene.speed_variation, 0.0, 0.95);
  requireRange("speed_period", scene.speed_period, 0.01, 1000.0, "s");
  requireRange("tf_rotation_deg", scene.tf_rotation_deg, -30.0, 30.0, "deg");
  const double axis = std::sqrt(dot(scene.tf_axis, scene.tf_axis));
  requireRange("tf_axis's length", axis, 1e-3, 1e3);
  requireRange("pose_rate", scene.pose_rate, 1.0, 10000.0, "1/s");
  requireRange("encoder_rate", scene.encoder_rate, 1.0, 100000.0, "1/s");
  requireRange("encoder_resolution", scene.encoder_resolution, 0.0, 0.01, "m");
  requireRange("rig_roll_deg", scene.rig_roll_deg, -180.0, 180.0, "deg");
}

void checkLaser(const SceneLaser& laser)
{
  requireRange("laser.lens_sigma_px", laser.lens_sigma_px, 0.3, 3.0, "px");
  requireRange("laser.sigma_px", laser.sigma_px, 1.05 * laser.lens_sigma_px, 12.0,
               "px (at least 1.05 laser.lens_sigma_px)");
  requireRange("laser.peak", laser.peak, 1.0, 100000.0, "DN");
  requireRange("laser.standoff", laser.standoff, 0.05, 5.0, "m");
  requireRange("laser.shading", laser.shading, 0.0, 1.0);
  requireRange("laser.specular", laser.specular, 0.0, 100.0);
  requireRange("laser.specular_width_deg", laser.specular_width_deg, 0.5, 60.0, "deg");
  requireRange("laser.bead_reflectance", laser.bead_reflectance, 0.0, 10.0);
  requireRange("laser.interreflection", laser.interreflection, 0.0, 10.0);
  requireRange("laser.ghost", laser.ghost, 0.0, 1.0);
  requireRange("laser.ghost_offset_px", laser.ghost_offset_px, -200.0, 200.0, "px");
  requireRange("laser.glow", laser.glow, 0.0, 1.0);
  requireRange("laser.glow_sigma_px", laser.glow_sigma_px, 3.0, 200.0, "px");
}

void checkSensor(const SceneParams& scene)
{
  requireRange("speckle.contrast", scene.speckle.contrast, 0.0, 1.0);
  requireRange("speckle.grain_px", scene.speckle.grain_px, 1.0, 20.0, "px");
  requireOneOf("sensor.encoding", scene.sensor.encoding, kEncodings);
  requireRange("sensor.snr", scene.sensor.snr, 1.0, 1000.0);
  requireRange("sensor.read_noise", scene.sensor.read_noise, 0.0, 50.0, "DN");
  requireRange("sensor.black_level", scene.sensor.black_level, 0.0, 100.0, "DN");
  const double peak = std::min(scene.laser.peak, kFullScale);
  const double noise = peak / scene.sensor.snr;
  const double floor = std::sqrt(scene.sensor.read_noise * scene.sensor.read_noise + kQuantisation);
  if (scene.sensor.noise && !(noise >= floor))
    throw ConfigError("sensor.snr is " + std::to_string(scene.sensor.snr) + ", must be at most " +
                      std::to_string(peak / floor) + ", what read noise and rounding leave at this laser.peak");
}

void checkLight(const SceneLight& light)
{
  requireRange("light.ambient", light.ambient, 0.0, 100000.0, "DN");
  requireRange("light.ambient_transmission", light.ambient_transmission, 0.0, 1.0);
  requireRange("light.arc", light.arc, 0.0, 100000.0, "DN");
  requireRange("light.arc_transmission", light.arc_transmission, 0.0, 1.0);
  requireRange("light.flash_share", light.flash_share, 0.0, 1.0);
  requireRange("light.flash", light.flash, 0.0, 1000000.0, "DN");
  requireRange("light.sparks", light.sparks, 0, 10000);
}

void checkCamera(const CameraCalibration& camera)
{
  requireRange("camera.image_width", camera.image_width, 16, 65535, "px");
  requireRange("camera.image_height", camera.image_height, 16, 65535, "px");
  requireRange("camera.fx", camera.fx, 10.0, 1e6, "px");
  requireRange("camera.fy", camera.fy, 10.0, 1e6, "px");
  requireRange("camera.cx", camera.cx, -1e5, 1e5, "px");
  requireRange("camera.cy", camera.cy, -1e5, 1e5, "px");
  for (const double coefficient : camera.distortion)
    requireRange("camera.distortion_coefficients", coefficient, -100.0, 100.0);
  requireRange("camera.roi x_offset", camera.roi_x, 0, camera.image_width - 1, "px");
  requireRange("camera.roi y_offset", camera.roi_y, 0, camera.image_height - 1, "px");
  requireRange("camera.roi width", camera.roi_width, 0, camera.image_width - camera.roi_x, "px");
  requireRange("camera.roi height", camera.roi_height, 0, camera.image_height - camera.roi_y, "px");
  if ((camera.roi_width == 0) != (camera.roi_height == 0) || (camera.roi_width == 0 && camera.roi_x + camera.roi_y > 0))
    throw ConfigError("camera.roi width is " + std::to_string(camera.roi_width) + " and its height " +
                      std::to_string(camera.roi_height) + ": set both, or neither and no offset");
  requireRange("camera.binning_x", camera.binning_x, 1, 1, "(the simulated camera does not bin)");
  requireRange("camera.binning_y", camera.binning_y, 1, 1, "(the simulated camera does not bin)");
}

void checkRig(const Calibration& calibration)
{
  checkCamera(calibration.camera);
  const auto& normal = calibration.laser_plane.normal;
  const auto& axis = calibration.stage.axis;
  requireUnit("laser_plane.normal", normal);
  requireUnit("stage.axis", axis);
  if (!(std::abs(dot(normal, axis)) >= 0.5))
    throw ConfigError("stage.axis lies " + std::to_string(std::asin(std::abs(dot(normal, axis))) * 57.29577951308232) +
                      " deg off the laser plane, the simulated rig needs at least 30");
  if (!(std::sqrt(axis[0] * axis[0] + axis[1] * axis[1]) >= kSinFiveDegrees))
    throw ConfigError("stage.axis lies within 5 deg of the optical axis, turn it");
  requireRange("laser_plane.distance / laser_plane.normal's z", calibration.laser_plane.distance / normal[2], 0.02,
               20.0, "m (where the optical axis meets the plane)");
  if (calibration.stage.type != "linear")
    throw ConfigError("stage.type is '" + calibration.stage.type + "', must be linear");
  requireRange("stage.metres_per_unit", calibration.stage.metres_per_unit, 1e-9, 1000.0, "m");
}
}  // namespace

void SceneParams::validate() const
{
  checkTime(*this);
  checkMotion(*this);
  simulation::checkPart(*this);
  checkLight(light);
  checkLaser(laser);
  checkSensor(*this);
  checkRig(calibration);
}

const std::vector<std::string>& presetNames()
{
  static const std::vector<std::string> names{ "realistic", "harsh" };
  return names;
}
}  // namespace weld_profiler
