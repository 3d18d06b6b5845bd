#include "weld_profiler/ros/scan_server.h"

#include <cmath>

#include <std_msgs/Header.h>
#include <boost/make_shared.hpp>

#include "weld_profiler/ros/messages.h"

namespace weld_profiler
{
namespace
{
constexpr double kLogPeriod = 5.0;    // seconds between two lines about the same trouble
constexpr double kPollPeriod = 2e-3;  // how often tf is asked for what waits [s]

ScanParams forReplay(ScanParams scan, bool lossless)
{
  if (lossless)
    scan.max_waiting = 100000;  // what waits for its bracketing sample is never given up
  return scan;
}
}  // namespace

void ScanServerParams::validate() const
{
  chain.validate();
}

ScanServer::ScanServer(const Handles& handles, const ScanServerParams& params, const Calibration& calibration,
                       const CalibrationRecord& record)
  : handles_(handles), params_(params), record_(record), updater_(handles.node, handles.own, handles.name)
{
  ScanChainParams chain = params.chain;
  chain.scan = forReplay(chain.scan, params.lossless);
  ScanBuilder::Sinks sinks;
  sinks.on_profile = [this](const Profile& profile) { onProfile(profile); };
  sinks.on_scan = [this](Scan&& scan) { onScan(std::move(scan)); };
  chain_ = std::make_unique<ScanChain>(chain, calibration, transforms_, std::move(sinks));
  chain_->builder().setScanning(params.auto_start);
  profiles_ = handles_.node.advertise<sensor_msgs::PointCloud2>("profile_points", 64);
  scans_ = handles_.node.advertise<sensor_msgs::PointCloud2>("scan_points", 1, true);
  started_ = handles_.node.advertise<std_msgs::Header>("scan_started", 1);
  ended_ = handles_.node.advertise<ScanInfo>("scan_info", 16, true);
  updater_.setHardwareID("none");
  updater_.add("triangulation", this, &ScanServer::diagnose);
}

ScanServer::~ScanServer()
{
  for (ros::WallTimer& timer : timers_)
    timer.stop();
  for (ros::Subscriber& subscriber : subscribers_)
    subscriber.shutdown();
  for (ros::ServiceServer& service : services_)
    service.shutdown();
}

void ScanServer::subscribe()
{
  ros::NodeHandle& node = handles_.node;
  services_ = { handles_.services.advertiseService("start_scan", &ScanServer::startScan, this),
                handles_.services.advertiseService("stop_scan", &ScanServer::stopScan, this),
                handles_.services.advertiseService("save_scan", &ScanServer::saveScanFile, this) };
  timers_.push_back(node.createWallTimer(ros::WallDuration(1.0), [this](const ros::WallTimerEvent&) { onSecond(); }));
  const std::uint32_t queue = params_.lossless ? 0 : 64;
  const std::uint32_t joint_queue = params_.lossless ? 0 : 2000;
  if (params_.chain.motion == "tf")
  {
    listener_ = std::make_unique<tf2_ros::TransformListener>(transforms_);
    timers_.push_back(
        node.createWallTimer(ros::WallDuration(kPollPeriod), [this](const ros::WallTimerEvent&) { onPoll(); }));
  }
  subscribers_ = { node.subscribe("camera_info", queue, &ScanServer::onCameraInfo, this),
                   node.subscribe("joint_states", joint_queue, &ScanServer::onJoints, this),
                   node.subscribe("stripe", queue, &ScanServer::onStripe, this) };
}

void ScanServer::use(const ScanParams& params)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  chain_->builder().use(forReplay(params, params_.lossless));
}

void ScanServer::onStripe(const StripeProfileConstPtr& stripe)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  camera_frame_ = stripe->header.frame_id;
  countGap(*stripe);
  chain_->addStripe(*stripe);
  sayProblem();
}

/// A gap in the count of the stripe nodelet: stripes that were published and never came here.
void ScanServer::countGap(const StripeProfile& stripe)
{
  const std::uint32_t seq = stripe.header.seq;
  if (last_stripe_seq_ != 0 && seq > last_stripe_seq_ + 1)
    chain_->builder().countDropped("lost_before_arrival", seq - last_stripe_seq_ - 1);
  last_stripe_seq_ = seq;
}

void ScanServer::onCameraInfo(const sensor_msgs::CameraInfoConstPtr& info)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  chain_->addCameraInfo(*info);
}

void ScanServer::onJoints(const sensor_msgs::JointStateConstPtr& joints)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  ++joint_messages_;
  if (chain_->addJoints(*joints))
  {
    joint_found_ = true;
    broadcastScanFrame();
  }
  else if (!joint_found_)
  {
    std::string names;
    for (const std::string& name : joints->name)
      names += (names.empty() ? "" : ", ") + name;
    ROS_WARN_STREAM_THROTTLE_NAMED(kLogPeriod, handles_.name,
                                   "[" << handles_.name << "] joint '" << chain_->calibration().stage.joint
                                       << "' is not in joint_states (there are: " << names
                                       << "), set stage/joint in the calibration file");
  }
}

void ScanServer::onProfile(const Profile& profile)
{
  const ros::Time now = ros::Time::now();
  age_.add((now - toRosTime(profile.stamp)).toSec(), now.toSec());
  if (profiles_.getNumSubscribers() > 0)
    profiles_.publish(sensor_msgs::PointCloud2ConstPtr(profileCloud(profile, chain_->cloudFrame())));
}

void ScanServer::onScan(Scan&& scan)
{
  last_scan_ = std::make_shared<const Scan>(std::move(scan));
  ++scans_ended_;
  published_rows_ = 0;
  const sensor_msgs::PointCloud2ConstPtr cloud = scanCloud(*last_scan_);
  scans_.publish(cloud);
  ended_.publish(scanInfo(cloud->header, *last_scan_));
}

ScanInfoConstPtr ScanServer::scanInfo(const std_msgs::Header& header, const Scan& scan) const
{
  auto info = boost::make_shared<ScanInfo>();
  info->header = header;
  info->rows = static_cast<std::uint32_t>(scan.rows.size());
  info->cells = scan.cells;
  info->end = static_cast<std::uint8_t>(scan.end);
  info->calibration = record_.file;
  info->calibration_hash = record_.hash;
  info->calibration_date = record_.date;
  return info;
}

void ScanServer::onPoll()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  chain_->poll();
}

void ScanServer::onSecond()
{
  sensor_msgs::PointCloud2ConstPtr cloud;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const Scan& open = chain_->builder().openScan();
    if (scans_.getNumSubscribers() > 0 && open.rows.size() > published_rows_)
    {
      published_rows_ = open.rows.size();
      scans_.publish(sensor_msgs::PointCloud2ConstPtr(scanCloud(open)));
    }
  }
  updater_.force_update();
}

void ScanServer::broadcastScanFrame()
{
  const EncoderTrack* encoder = chain_->encoder();
  if (encoder == nullptr || encoder->empty() || camera_frame_.empty() || !std::isfinite(encoder->latestPosition()))
    return;
  const Eigen::Isometry3d pose = chain_->scanFrame().cameraTScan(encoder->latestPosition());
  broadcaster_.sendTransform(transformMessage(encoder->latestStamp(), pose.linear(), pose.translation(),
                                              FrameNames{ camera_frame_, params_.chain.scan_frame }));
}

void ScanServer::sayProblem()
{
  const std::string problem = chain_->takeProblem();
  if (!problem.empty())
    ROS_ERROR_STREAM_THROTTLE_NAMED(kLogPeriod, handles_.name,
                                    "[" << handles_.name << "] " << problem << "; the frame is dropped");
}
}  // namespace weld_profiler
