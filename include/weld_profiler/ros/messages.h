#pragma once

#include <string>

#include <geometry_msgs/TransformStamped.h>
#include <ros/time.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/JointState.h>
#include <sensor_msgs/PointCloud2.h>
#include <Eigen/Geometry>

#include "weld_profiler/StripeProfile.h"
#include "weld_profiler/core/frame.h"
#include "weld_profiler/core/image.h"
#include "weld_profiler/core/scan.h"
#include "weld_profiler/core/stamp.h"
#include "weld_profiler/core/stripe.h"
#include "weld_profiler/geometry/calibration.h"

namespace weld_profiler
{
// Where a value meets a message. Nothing here computes.

ros::Time toRosTime(Stamp stamp);
Stamp fromRosTime(const ros::Time& time);

/// Moves the frame's pixels into a message: no copy.
sensor_msgs::ImagePtr imageMessage(Frame&& frame, const std::string& frame_id);

/// A view on the message's pixels; valid as long as the message.
/// @throws PreconditionError when width, height, step and the data's length do not fit together.
RawImage rawImage(const sensor_msgs::Image& message);

sensor_msgs::CameraInfo cameraInfoMessage(const CameraCalibration& camera);

/// One joint, position in the joint's units.
sensor_msgs::JointState jointStateMessage(Stamp stamp, const std::string& joint, double position);

/// Who is where: child's pose in parent.
struct FrameNames
{
  std::string parent;
  std::string child;
};

/// p_parent = rotation * p_child + translation.
geometry_msgs::TransformStamped transformMessage(Stamp stamp, const Eigen::Matrix3d& rotation,
                                                 const Eigen::Vector3d& translation, const FrameNames& frames);

/// Says in one line why camera_info does not fit the calibration or the image (size, ROI, binning, K within 1e-6
/// relative, zero K); empty = fits.
std::string cameraInfoMismatch(const sensor_msgs::CameraInfo& info, const CameraCalibration& camera);

/// The calibration's camera replaced by what camera_info says (`use_camera_info: true`).
/// @throws ConfigError for a distortion model other than plumb_bob or a zero K.
CameraCalibration cameraFromInfo(const sensor_msgs::CameraInfo& info);

/// Swaps the stripe's arrays into the message's (and the message's old ones into the stripe): no copy.
void swapStripe(Stripe& stripe, StripeProfile& message);

/// Copies the message's arrays into a stripe, reusing its memory.
/// @throws PreconditionError when the arrays have different lengths.
void copyStripe(const StripeProfile& message, Stripe& stripe);

/// point_step 32: x y z intensity sigma stage time (FLOAT32) and flags (UINT8) at 28. One row, valid points only.
sensor_msgs::PointCloud2Ptr profileCloud(const Profile& profile, const std::string& frame_id);

/// The organised scan: a row a profile, a column a cell, holes NaN, is_dense false, stamp = first row's.
sensor_msgs::PointCloud2Ptr scanCloud(const Scan& scan);
}  // namespace weld_profiler
