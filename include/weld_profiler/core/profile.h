#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Geometry>

#include "weld_profiler/core/stamp.h"
#include "weld_profiler/core/stripe.h"

namespace weld_profiler
{
/// One triangulated point, not yet placed: camera optical frame, metres.
struct SensorPoint
{
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< [m], camera optical frame
  Eigen::Vector3f spread = Eigen::Vector3f::Zero();    ///< move of the point for 1 sigma of the stripe centre [m]
  float intensity = 0.0F;                              ///< peak above background [DN]
  std::uint16_t cell = 0;                              ///< column in the organised cloud
  std::uint8_t flags = 0;                              ///< OR of stripe_flag
};

/// One frame's points in the camera optical frame, waiting to be placed. Empty points = no stripe.
struct SensorProfile
{
  Stamp stamp = 0;          ///< middle of the exposure
  std::uint64_t frame = 0;  ///< the driver's frame counter
  Direction direction = Direction::AlongU;
  std::uint32_t cells = 0;  ///< width of the organised cloud: image width, or height for AlongV
  std::vector<SensorPoint> points;
};

/// Where the sensor was at a stamp.
struct SensorPose
{
  Eigen::Isometry3d cloud_T_camera = Eigen::Isometry3d::Identity();  ///< maps camera points to the cloud's frame
  double stage = 0.0;                                                ///< stage position or path length [m]
};

/// One point of a cloud, in its frame (see SensorPose), metres.
struct CloudPoint
{
  float x = 0.0F, y = 0.0F, z = 0.0F;
  float intensity = 0.0F;  ///< peak above background [DN]
  float sigma = 0.0F;      ///< 1-sigma in z [m]
  std::uint16_t cell = 0;  ///< column in the organised cloud
  std::uint8_t flags = 0;  ///< OR of stripe_flag
};

/// One placed profile: rising cells, holes left out. Empty points = a row of NaN.
struct Profile
{
  Stamp stamp = 0;
  std::uint64_t frame = 0;
  double stage = 0.0;  ///< [m]
  std::uint32_t cells = 0;
  std::vector<CloudPoint> points;
};
}  // namespace weld_profiler
