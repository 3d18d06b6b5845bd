#include "weld_profiler/ros/messages.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include <sensor_msgs/distortion_models.h>
#include <sensor_msgs/image_encodings.h>
#include <boost/make_shared.hpp>

#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
ros::Time toRosTime(Stamp stamp)
{
  ros::Time time;
  time.fromNSec(static_cast<std::uint64_t>(std::max<Stamp>(stamp, 0)));
  return time;
}

Stamp fromRosTime(const ros::Time& time)
{
  return static_cast<Stamp>(time.toNSec());
}

sensor_msgs::ImagePtr imageMessage(Frame&& frame, const std::string& frame_id)
{
  auto message = boost::make_shared<sensor_msgs::Image>();
  message->header.stamp = toRosTime(frame.stamp);
  message->header.frame_id = frame_id;
  message->header.seq = static_cast<std::uint32_t>(frame.number);
  message->width = static_cast<std::uint32_t>(frame.width);
  message->height = static_cast<std::uint32_t>(frame.height);
  message->step = static_cast<std::uint32_t>(frame.step);
  message->encoding = frame.encoding;
  message->is_bigendian = 0;
  message->data = std::move(frame.pixels);
  return message;
}

RawImage rawImage(const sensor_msgs::Image& message)
{
  std::ostringstream text;
  text << "image of " << message.width << " x " << message.height << " (" << message.encoding << ", step "
       << message.step << ", " << message.data.size() << " bytes)";
  if (message.width == 0 || message.height == 0 || message.data.empty())
    throw PreconditionError(text.str() + " is empty");
  std::size_t pixel_bytes = 1;
  try
  {
    const auto channels = static_cast<std::size_t>(sensor_msgs::image_encodings::numChannels(message.encoding));
    pixel_bytes = static_cast<std::size_t>(sensor_msgs::image_encodings::bitDepth(message.encoding)) / 8 * channels;
  }
  catch (const std::runtime_error&)
  {
    throw PreconditionError("image encoding '" + message.encoding +
                            "' is unknown, publish mono8, mono16, bayer or rgb");
  }
  if (message.step < message.width * pixel_bytes ||
      message.data.size() < static_cast<std::size_t>(message.step) * message.height)
    throw PreconditionError(text.str() + " does not hold the pixels it promises");
  return RawImage{ message.data.data(), static_cast<int>(message.width), static_cast<int>(message.height), message.step,
                   message.encoding,    message.is_bigendian != 0 };
}

sensor_msgs::CameraInfo cameraInfoMessage(const CameraCalibration& camera)
{
  sensor_msgs::CameraInfo info;
  info.width = static_cast<std::uint32_t>(camera.image_width);
  info.height = static_cast<std::uint32_t>(camera.image_height);
  info.distortion_model = sensor_msgs::distortion_models::PLUMB_BOB;
  info.D.assign(camera.distortion.begin(), camera.distortion.end());
  info.K = { { camera.fx, 0.0, camera.cx, 0.0, camera.fy, camera.cy, 0.0, 0.0, 1.0 } };
  info.R = { { 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0 } };
  info.P = { { camera.fx, 0.0, camera.cx, 0.0, 0.0, camera.fy, camera.cy, 0.0, 0.0, 0.0, 1.0, 0.0 } };
  info.binning_x = static_cast<std::uint32_t>(camera.binning_x);
  info.binning_y = static_cast<std::uint32_t>(camera.binning_y);
  info.roi.x_offset = static_cast<std::uint32_t>(camera.roi_x);
  info.roi.y_offset = static_cast<std::uint32_t>(camera.roi_y);
  info.roi.width = static_cast<std::uint32_t>(camera.roi_width);
  info.roi.height = static_cast<std::uint32_t>(camera.roi_height);
  return info;
}

sensor_msgs::JointState jointStateMessage(Stamp stamp, const std::string& joint, double position)
{
  sensor_msgs::JointState message;
  message.header.stamp = toRosTime(stamp);
  message.name.assign(1, joint);
  message.position.assign(1, position);
  return message;
}

geometry_msgs::TransformStamped transformMessage(Stamp stamp, const Eigen::Matrix3d& rotation,
                                                 const Eigen::Vector3d& translation, const FrameNames& frames)
{
  const Eigen::Quaterniond q(rotation);
  geometry_msgs::TransformStamped message;
  message.header.stamp = toRosTime(stamp);
  message.header.frame_id = frames.parent;
  message.child_frame_id = frames.child;
  message.transform.translation.x = translation.x();
  message.transform.translation.y = translation.y();
  message.transform.translation.z = translation.z();
  message.transform.rotation.x = q.x();
  message.transform.rotation.y = q.y();
  message.transform.rotation.z = q.z();
  message.transform.rotation.w = q.w();
  return message;
}

namespace
{
/// 0 and 1 both mean "not binned" in CameraInfo, and a region of 0 x 0 the whole sensor.
std::uint32_t binning(std::uint32_t value)
{
  return std::max<std::uint32_t>(value, 1);
}

std::uint32_t extent(std::uint32_t roi, std::uint32_t whole)
{
  return roi == 0 ? whole : roi;
}

bool differs(double a, double b)
{
  return !(std::abs(a - b) <= 1e-6 * std::max(std::abs(a), std::abs(b)));
}
}  // namespace

std::string cameraInfoMismatch(const sensor_msgs::CameraInfo& info, const CameraCalibration& camera)
{
  std::ostringstream text;
  const auto say = [&text](const char* what, double got, double expected)
  {
    text << "camera_info " << what << " is " << got << ", the calibration's is " << expected
         << ": use the calibration of this camera mode, or set use_camera_info";
    return text.str();
  };
  const sensor_msgs::CameraInfo own = cameraInfoMessage(camera);
  if (!(info.K[0] > 0.0 && info.K[4] > 0.0))
    return say("K[0]", info.K[0], own.K[0]);
  if (info.width != own.width)
    return say("width", info.width, own.width);
  if (info.height != own.height)
    return say("height", info.height, own.height);
  if (binning(info.binning_x) != binning(own.binning_x) || binning(info.binning_y) != binning(own.binning_y))
    return say("binning", binning(info.binning_x), binning(own.binning_x));
  if (info.roi.x_offset != own.roi.x_offset)
    return say("roi.x_offset", info.roi.x_offset, own.roi.x_offset);
  if (info.roi.y_offset != own.roi.y_offset)
    return say("roi.y_offset", info.roi.y_offset, own.roi.y_offset);
  if (extent(info.roi.width, info.width) != extent(own.roi.width, own.width))
    return say("roi.width", extent(info.roi.width, info.width), extent(own.roi.width, own.width));
  if (extent(info.roi.height, info.height) != extent(own.roi.height, own.height))
    return say("roi.height", extent(info.roi.height, info.height), extent(own.roi.height, own.height));
  for (const std::size_t i : { 0, 2, 4, 5 })
  {
    if (differs(info.K[i], own.K[i]))
      return say(("K[" + std::to_string(i) + "]").c_str(), info.K[i], own.K[i]);
  }
  return "";
}

CameraCalibration cameraFromInfo(const sensor_msgs::CameraInfo& info)
{
  if (!info.distortion_model.empty() && info.distortion_model != sensor_msgs::distortion_models::PLUMB_BOB)
    throw ConfigError("camera_info distortion_model is '" + info.distortion_model + "', must be plumb_bob");
  if (!(info.K[0] > 0.0 && info.K[4] > 0.0))
    throw ConfigError("camera_info K is zero: calibrate the camera, or set use_camera_info to false");
  CameraCalibration camera;
  camera.image_width = static_cast<int>(info.width);
  camera.image_height = static_cast<int>(info.height);
  camera.fx = info.K[0];
  camera.fy = info.K[4];
  camera.cx = info.K[2];
  camera.cy = info.K[5];
  for (std::size_t i = 0; i < camera.distortion.size() && i < info.D.size(); ++i)
    camera.distortion[i] = info.D[i];
  camera.roi_x = static_cast<int>(info.roi.x_offset);
  camera.roi_y = static_cast<int>(info.roi.y_offset);
  camera.roi_width = static_cast<int>(info.roi.width);
  camera.roi_height = static_cast<int>(info.roi.height);
  camera.binning_x = static_cast<int>(binning(info.binning_x));
  camera.binning_y = static_cast<int>(binning(info.binning_y));
  return camera;
}

void swapStripe(Stripe& stripe, StripeProfile& message)
{
  message.direction = static_cast<std::uint8_t>(stripe.direction);
  message.status = static_cast<std::uint8_t>(stripe.status);
  message.cell.swap(stripe.cell);
  message.u.swap(stripe.u);
  message.v.swap(stripe.v);
  message.normal_angle.swap(stripe.normal_angle);
  message.intensity.swap(stripe.intensity);
  message.stripe_width.swap(stripe.width);
  message.sigma.swap(stripe.sigma);
  message.flags.swap(stripe.flags);
}

void copyStripe(const StripeProfile& message, Stripe& stripe)
{
  const std::size_t count = message.cell.size();
  for (const std::size_t length :
       { message.u.size(), message.v.size(), message.normal_angle.size(), message.intensity.size(),
         message.stripe_width.size(), message.sigma.size(), message.flags.size() })
  {
    if (length != count)
      throw PreconditionError("stripe arrays have different lengths (" + std::to_string(count) + " cells, " +
                              std::to_string(length) + " values): the publisher is broken");
  }
  stripe.direction = message.direction == StripeProfile::ALONG_V ? Direction::AlongV : Direction::AlongU;
  stripe.status = static_cast<StripeStatus>(message.status);
  stripe.cell = message.cell;
  stripe.u = message.u;
  stripe.v = message.v;
  stripe.normal_angle = message.normal_angle;
  stripe.intensity = message.intensity;
  stripe.width = message.stripe_width;
  stripe.sigma = message.sigma;
  stripe.flags = message.flags;
}
}  // namespace weld_profiler
