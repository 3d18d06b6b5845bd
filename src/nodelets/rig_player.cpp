#include "rig_player.h"

#include <algorithm>
#include <filesystem>

#include <sensor_msgs/JointState.h>

#include "weld_profiler/core/errors.h"
#include "weld_profiler/core/frame.h"
#include "weld_profiler/ros/messages.h"
#include "weld_profiler/simulation/truth_writer.h"

namespace weld_profiler
{
namespace
{
constexpr double kLeadTime = 0.5;       // between announcing a scan and its first sample [s]
constexpr double kLongestSleep = 0.02;  // so that unloading waits for nothing [s]
constexpr double kLate = 0.02;          // an event published later than this counts as late [s]

SceneParams sceneOf(const std::string& name)
{
  const auto& presets = presetNames();
  if (std::find(presets.begin(), presets.end(), name) != presets.end())
    return scenePreset(name);
  if (!std::filesystem::exists(name))
    requireOneOf("simulated_rig/scene is no file, so it", name, presets);
  return loadScene(name);
}
}  // namespace

/// Something to publish at its time.
struct RigPlayer::Event
{
  enum class Kind
  {
    Encoder,
    Pose,
    Image
  };
  Stamp due = 0;
  Kind kind = Kind::Encoder;
  std::size_t index = 0;
};

void RigPlayerParams::validate() const
{
  requireRange("simulated_rig/prerender_frames", prerender_frames, 0, 100000, "frames");
  if (scene.empty())
    throw ConfigError("simulated_rig/scene is '', must be a preset or the path of a scene file");
}

RigPlayer::RigPlayer(ros::NodeHandle& node, ros::NodeHandle& own, const RigPlayerParams& params,
                     const std::string& name)
  : params_((params.validate(), params)), name_(name), scene_(sceneOf(params.scene)), updater_(node, own, name)
{
  scene_.validate();
  images_ = image_transport::ImageTransport(node).advertiseCamera("image_raw", 8);
  joints_ = node.advertise<sensor_msgs::JointState>("joint_states", 1000);
  broadcaster_ = std::make_unique<tf2_ros::TransformBroadcaster>();
  updater_.setHardwareID("simulated");
  updater_.add("simulated rig", this, &RigPlayer::diagnose);
  timer_ =
      node.createWallTimer(ros::WallDuration(1.0), [this](const ros::WallTimerEvent&) { updater_.force_update(); });
  thread_ = std::thread([this] { run(); });
}

RigPlayer::~RigPlayer()
{
  timer_.stop();
  stop_ = true;
  thread_.join();
}

void RigPlayer::run()
{
  try
  {
    prerender();
    state_ = "waiting for a subscriber";
    if (params_.wait_for_subscriber)
      waitForSubscriber();
    do
    {
      state_ = "scanning";
      playOnce();
    } while (params_.loop && !stop_);
    state_ = "scan finished";
    if (!stop_)
      ROS_INFO_STREAM_NAMED(name_, "[" << name_ << "] the scan is finished, " << published_ << " images in all");
  }
  catch (const std::exception& error)
  {
    state_ = "failed";
    ROS_ERROR_STREAM_NAMED(name_, "[" << name_ << "] " << error.what());
  }
}

void RigPlayer::prerender()
{
  const SimulatedScan scan(scene_);
  rendered_.resize(static_cast<std::size_t>(std::min(scan.frameCount(), params_.prerender_frames)));
  for (std::size_t i = 0; i < rendered_.size() && !stop_; ++i)
    scan.render(static_cast<int>(i), rendered_[i]);
}

void RigPlayer::waitForSubscriber() const
{
  while (!stop_ && images_.getNumSubscribers() == 0)
    ros::WallDuration(kLongestSleep).sleep();
}

void RigPlayer::playOnce()
{
  SceneParams scene = scene_;
  const double lead = params_.truth_dir.empty() ? kLeadTime : 10.0 * kLeadTime;  // the truth takes time to write
  scene.start_time = ros::Time::now().toSec() + lead;
  const SimulatedScan scan(scene);
  if (!params_.truth_dir.empty())
    writeTruth(scan, params_.truth_dir);
  const std::vector<SimulatedEncoderSample> encoder = scan.encoder();
  const std::vector<SimulatedPose> poses = scan.poses();
  for (const Event& event : timeline(scan))
  {
    if (!sleepUntil(event.due))
      return;
    if (event.kind == Event::Kind::Image)
      publishFrame(scan, static_cast<int>(event.index));
    else if (event.kind == Event::Kind::Pose)
      publishPose(poses[event.index]);
    else
      joints_.publish(boost::make_shared<sensor_msgs::JointState>(jointStateMessage(
          encoder[event.index].stamp, scan.calibration().stage.joint, encoder[event.index].position)));
    if (fromRosTime(ros::Time::now()) - event.due > fromSeconds(kLate))
      ++late_;
  }
}

std::vector<RigPlayer::Event> RigPlayer::timeline(const SimulatedScan& scan) const
{
  std::vector<Event> events;
  const std::vector<SimulatedEncoderSample> encoder = scan.encoder();
  for (std::size_t i = 0; i < encoder.size(); ++i)
    events.push_back(Event{ encoder[i].stamp, Event::Kind::Encoder, i });
  const std::vector<SimulatedPose> poses = scan.poses();
  for (std::size_t i = 0; i < poses.size(); ++i)
    events.push_back(Event{ poses[i].stamp, Event::Kind::Pose, i });
  for (int i = 0; i < scan.frameCount(); ++i)
    events.push_back(
        Event{ scan.stamp(i) + fromSeconds(0.5 * scene_.exposure), Event::Kind::Image, static_cast<std::size_t>(i) });
  std::stable_sort(events.begin(), events.end(), [](const Event& a, const Event& b) { return a.due < b.due; });
  return events;
}

void RigPlayer::publishFrame(const SimulatedScan& scan, int index)
{
  Frame frame;
  const auto place = static_cast<std::size_t>(index);
  if (place < rendered_.size())
    frame.pixels = rendered_[place];
  else
    scan.render(index, frame.pixels);
  frame.width = scan.width();
  frame.height = scan.height();
  frame.step = scan.step();
  frame.encoding = scan.encoding();
  frame.stamp = scan.stamp(index);
  frame.number = ++published_;
  const sensor_msgs::ImagePtr image = imageMessage(std::move(frame), params_.frame_id);
  const auto info = boost::make_shared<sensor_msgs::CameraInfo>(cameraInfoMessage(scan.calibration().camera));
  info->header = image->header;
  images_.publish(image, info);
}

void RigPlayer::publishPose(const SimulatedPose& pose)
{
  Eigen::Matrix3d rotation = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(pose.rotation.data());
  broadcaster_->sendTransform(transformMessage(pose.stamp, rotation,
                                               Eigen::Map<const Eigen::Vector3d>(pose.translation.data()),
                                               FrameNames{ params_.fixed_frame, params_.frame_id }));
}

bool RigPlayer::sleepUntil(Stamp stamp) const
{
  while (!stop_)
  {
    const double left = toSeconds(stamp - fromRosTime(ros::Time::now()));
    if (left <= 0.0)
      return true;
    ros::WallDuration(std::min(left, kLongestSleep)).sleep();
  }
  return false;
}

void RigPlayer::diagnose(diagnostic_updater::DiagnosticStatusWrapper& status)
{
  status.summary(diagnostic_msgs::DiagnosticStatus::OK, state_.load());
  status.add("frames published", published_.load());
  status.add("events late", late_.load());
}
}  // namespace weld_profiler
