#include "weld_profiler/ros/scan_chain.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "weld_profiler/core/errors.h"
#include "weld_profiler/ros/messages.h"

namespace weld_profiler
{
namespace
{
bool sameCamera(const sensor_msgs::CameraInfo& a, const sensor_msgs::CameraInfo& b)
{
  return a.width == b.width && a.height == b.height && a.K == b.K && a.D == b.D && a.binning_x == b.binning_x &&
         a.binning_y == b.binning_y && a.roi.x_offset == b.roi.x_offset && a.roi.y_offset == b.roi.y_offset &&
         a.roi.width == b.roi.width && a.roi.height == b.roi.height;
}
}  // namespace

void ScanChainParams::validate() const
{
  requireOneOf("triangulation/motion", motion, std::vector<std::string>{ "stage", "tf" });
  if (motion == "tf" && fixed_frame.empty())
    throw ConfigError("triangulation/fixed_frame is '', must name the clouds' frame when motion is tf");
  if (scan_frame.empty())
    throw ConfigError("triangulation/scan_frame is '', must be the name of a frame");
  encoder.validate();
  scan.validate();
}

ScanChain::ScanChain(const ScanChainParams& params, const Calibration& calibration, const tf2::BufferCore& transforms,
                     ScanBuilder::Sinks sinks)
  : params_(params), calibration_(calibration), scan_frame_(calibration)
{
  params.validate();
  triangulator_ = std::make_shared<const Triangulator>(calibration);
  std::unique_ptr<PoseSource> poses;
  if (params.motion == "tf")
  {
    auto source = std::make_unique<TfPoseSource>(transforms, params.fixed_frame);
    transforms_ = source.get();
    cloud_frame_ = params.fixed_frame;
    poses = std::move(source);
  }
  else
  {
    auto source = std::make_unique<EncoderPoseSource>(calibration, params.encoder);
    encoder_ = source.get();
    cloud_frame_ = params.scan_frame;
    poses = std::move(source);
  }
  builder_ = std::make_unique<ScanBuilder>(params.scan, std::move(poses), cloud_frame_, std::move(sinks));
}

void ScanChain::addCameraInfo(const sensor_msgs::CameraInfo& info)
{
  if (info_ && sameCamera(info, *info_))
    return;
  info_ = info;
  if (!params_.use_camera_info)
  {
    info_problem_ = cameraInfoMismatch(info, calibration_.camera);
    return;
  }
  try
  {
    Calibration calibration = calibration_;
    calibration.camera = cameraFromInfo(info);
    triangulator_ = std::make_shared<const Triangulator>(calibration);
    info_problem_.clear();
  }
  catch (const Error& error)
  {
    info_problem_ = error.what();
  }
}

bool ScanChain::fits(const StripeProfile& stripe)
{
  if (params_.use_camera_info && !info_)
  {
    refuse("camera_info",
           "there is no camera_info yet and use_camera_info is set: publish it, or use the calibration's");
    return false;
  }
  if (!info_problem_.empty())
  {
    refuse("camera_info", info_problem_);
    return false;
  }
  const CameraModel& camera = triangulator_->camera();
  if (static_cast<int>(stripe.image_width) != camera.width() ||
      static_cast<int>(stripe.image_height) != camera.height())
  {
    refuse("image_size", "image is " + std::to_string(stripe.image_width) + " x " +
                             std::to_string(stripe.image_height) + ", the calibration's " +
                             std::to_string(camera.width()) + " x " + std::to_string(camera.height()) +
                             ": use the calibration of this camera mode");
    return false;
  }
  return true;
}

void ScanChain::addStripe(const StripeProfile& stripe)
{
  if (!fits(stripe))
    return;
  SensorProfile profile;
  profile.stamp = fromRosTime(stripe.header.stamp);
  profile.frame = stripe.frame;
  try
  {
    copyStripe(stripe, stripe_);
    profile.direction = stripe_.direction;
    profile.cells = stripe_.direction == Direction::AlongU ? stripe.image_width : stripe.image_height;
    triangulator_->triangulate(stripe_, profile);
  }
  catch (const PreconditionError& error)
  {
    refuse("bad_message", error.what());
    return;
  }
  if (transforms_ != nullptr)
    transforms_->setCameraFrame(stripe.header.frame_id);
  builder_->addProfile(std::move(profile));
}

bool ScanChain::addJoints(const sensor_msgs::JointState& joints)
{
  const auto name = std::find(joints.name.begin(), joints.name.end(), calibration_.stage.joint);
  const auto index = static_cast<std::size_t>(name - joints.name.begin());
  if (index >= joints.name.size() || index >= joints.position.size())
    return false;
  if (encoder_ == nullptr)
    return true;
  if (!encoder_->addSample(fromRosTime(joints.header.stamp), joints.position[index]))
    builder_->timeBackwards();
  builder_->poll();
  return true;
}

std::string ScanChain::takeProblem()
{
  std::string text;
  text.swap(problem_);
  return text;
}

void ScanChain::refuse(const std::string& reason, const std::string& text)
{
  builder_->countDropped(reason);
  problem_ = text;
}
}  // namespace weld_profiler
