#pragma once

#include <array>
#include <string>
#include <vector>

namespace weld_profiler
{
// Plain values only: simulation shares these structs and no code.

/// Pinhole camera with ROS `plumb_bob` distortion, for the full sensor.
struct CameraCalibration
{
  int image_width = 1440;              ///< [px]
  int image_height = 1080;             ///< [px]
  double fx = 6000.0, fy = 6000.0;     ///< focal lengths [px]
  double cx = 719.5, cy = 539.5;       ///< principal point [px], pixel centres at integers
  std::array<double, 5> distortion{};  ///< k1 k2 p1 p2 k3
  int roi_x = 0, roi_y = 0;            ///< where the image sits on the sensor [px], as in CameraInfo
  int roi_width = 0, roi_height = 0;   ///< 0 = whole sensor
  int binning_x = 1, binning_y = 1;
};

/// Points p in the camera optical frame with normal . p = distance.
struct LaserPlaneCalibration
{
  std::array<double, 3> normal{ { 0.0, 0.8660254037844386, 0.5 } };  ///< unit
  double distance = 0.125;                                           ///< [m]
};

/// How the sensor moves over the part.
struct StageCalibration
{
  std::string type = "linear";                                       ///< linear; rotary is refused until built
  std::string joint = "stage_joint";                                 ///< name in JointState
  std::array<double, 3> axis{ { 0.0, -0.8660254037844386, -0.5 } };  ///< unit, camera optical frame, sensor over part
  double metres_per_unit = 1.0;                                      ///< JointState position times this is metres
};

/// The calibration file's content. Defaults: the default rig, 60 mm field at 0.25 m, 41.7 um/px across.
struct Calibration
{
  CameraCalibration camera;
  LaserPlaneCalibration laser_plane;
  StageCalibration stage;
};
}  // namespace weld_profiler
