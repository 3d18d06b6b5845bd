#include "weld_profiler/ros/weld_server.h"

#include <filesystem>

#include "weld_profiler/core/errors.h"
#include "weld_profiler/ros/diagnostics.h"
#include "weld_profiler/ros/messages.h"
#include "weld_profiler/ros/weld_markers.h"
#include "weld_profiler/ros/weld_messages.h"

namespace weld_profiler
{
namespace
{
constexpr std::size_t kWaitingScans = 4;
constexpr double kFetchTime = 10.0;  // a latched cloud comes at once; a large one over the network takes a while [s]
constexpr double kSpinTime = 0.1;    // [s]
constexpr double kLogPeriod = 5.0;   // [s]
}  // namespace

void WeldServerParams::validate() const
{
  settings.validate();
  requireRange("rest_time", rest_time, 0.1, 60.0, "s");
}

WeldServer::WeldServer(const Handles& handles, const WeldServerParams& params)
  : handles_(handles),
    params_(params),
    evaluator_(std::make_shared<const WeldEvaluator>(params.settings)),
    grinding_(handles.node, params.output_frame),
    updater_(handles.node, handles.own, handles.name),
    live_(evaluator_->measurer()),
    queue_(kWaitingScans, false)
{
  params.validate();
  measured_ = handles_.node.advertise<WeldMeasurement>("weld", 64);
  summary_ = handles_.node.advertise<WeldMeasurement>("weld_summary", 1, true);
  markers_ = handles_.node.advertise<visualization_msgs::MarkerArray>("weld_markers", 1, true);
  section_marker_ = handles_.node.advertise<visualization_msgs::MarkerArray>("section_markers", 1);
  updater_.setHardwareID("none");
  updater_.add("weld_measurement", this, &WeldServer::diagnose);
}

WeldServer::~WeldServer()
{
  stopping_ = true;
  for (ros::Subscriber& subscriber : subscribers_)
    subscriber.shutdown();
  second_.stop();
  queue_.close();
  if (worker_.joinable())
    worker_.join();
}

void WeldServer::subscribe()
{
  grinding_.listen();
  worker_ = std::thread([this] { work(); });
  second_ = handles_.node.createWallTimer(ros::WallDuration(1.0),
                                          [this](const ros::WallTimerEvent&) { updater_.force_update(); });
  subscribers_ = { handles_.node.subscribe("scan_info", 16, &WeldServer::onScanInfo, this),
                   handles_.node.subscribe("profile_points", 64, &WeldServer::onProfile, this) };
}

void WeldServer::order(const WeldOrder& order, std::function<void(const WeldOutcome&)> done)
{
  Order made{ std::make_shared<const WeldEvaluator>(order.settings), order.weld_id, std::move(done) };
  const std::lock_guard<std::mutex> lock(mutex_);
  order_ = std::move(made);
}

void WeldServer::cancelOrder()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  order_ = Order{};
}

void WeldServer::onProfile(const sensor_msgs::PointCloud2ConstPtr& cloud)
try
{
  const Profile profile = profileFromCloud(*cloud);
  travel_.add(profile, (ros::Time::now() - cloud->header.stamp).toSec());
  if (measured_.getNumSubscribers() == 0 && section_marker_.getNumSubscribers() == 0)
    return;
  const WeldSection section = measureLive(profile);
  auto message = boost::make_shared<WeldMeasurement>();
  message->header = cloud->header;
  message->type = WeldMeasurement::LIVE;
  message->sections.push_back(sectionMessage(section, nullptr));
  measured_.publish(WeldMeasurementConstPtr(message));
  if (section_marker_.getNumSubscribers() > 0)
    section_marker_.publish(sectionMarkers(section, profile, cloud->header));
}
catch (const PreconditionError& error)
{
  ROS_ERROR_STREAM_THROTTLE_NAMED(kLogPeriod, handles_.name, "[" << handles_.name << "] " << error.what());
}

WeldSection WeldServer::measureLive(const Profile& profile)
{
  const std::lock_guard<std::mutex> lock(live_mutex_);
  return live_.measure(profile);
}

void WeldServer::onScanInfo(const ScanInfoConstPtr& info)
{
  {
    const std::lock_guard<std::mutex> lock(live_mutex_);
    live_.restart();
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  Job job{ info, std::move(order_) };
  order_ = Order{};
  if (!job.order.evaluator)
    job.order.evaluator = evaluator_;
  lost_ += queue_.push(std::move(job));
}

void WeldServer::work()
{
  Job job;
  while (queue_.pop(job))
  {
    measure(job);
    job = Job{};
  }
}

/// The scan itself, which is latched: nobody has to keep it meanwhile.
sensor_msgs::PointCloud2ConstPtr WeldServer::fetch(const ScanInfo& info)
{
  sensor_msgs::PointCloud2ConstPtr found;
  ros::SubscribeOptions options = ros::SubscribeOptions::create<sensor_msgs::PointCloud2>(
      handles_.node.resolveName("scan_points"), 2,
      [&](const sensor_msgs::PointCloud2ConstPtr& cloud)
      {
        if (cloud->header.stamp == info.header.stamp && cloud->height == info.rows)
          found = cloud;
      },
      ros::VoidPtr(), &fetched_);
  ros::NodeHandle node = handles_.node;
  ros::Subscriber subscriber = node.subscribe(options);
  const ros::WallTime until = ros::WallTime::now() + ros::WallDuration(kFetchTime);
  while (!found && !stopping_ && ros::WallTime::now() < until)
    fetched_.callAvailable(ros::WallDuration(kSpinTime));
  return found;
}

void WeldServer::measure(const Job& job)
{
  WeldOutcome outcome;
  try
  {
    const sensor_msgs::PointCloud2ConstPtr cloud = fetch(*job.info);
    if (stopping_)
      return;
    if (!cloud)
      throw InputError("the scan of " + std::to_string(job.info->rows) +
                       " rows did not come on scan_points: another has taken its place");
    outcome = evaluate(job, *cloud);
  }
  catch (const std::exception& error)
  {
    outcome.summary.header = job.info->header;
    outcome.summary.type = WeldMeasurement::SUMMARY;
    outcome.summary.kind = name(WeldKind::None);
    outcome.summary.reason = outcome.trouble = error.what();
  }
  if (!outcome.trouble.empty())
    ROS_ERROR_STREAM_NAMED(handles_.name, "[" << handles_.name << "] " << outcome.trouble);
  if (job.order.done)
    job.order.done(outcome);
}

WeldOutcome WeldServer::evaluate(const Job& job, const sensor_msgs::PointCloud2& cloud)
{
  const Scan scan = scanFromCloud(cloud);
  const WeldEvaluation evaluation = job.order.evaluator->evaluate(scan);
  WeldOutcome outcome;
  outcome.verdict = evaluation.verdict;
  outcome.summary = measurementMessage(evaluation);
  outcome.summary.header = cloud.header;
  outcome.summary.weld_id = job.order.weld_id;
  outcome.summary.settings = settingsText(job.order.evaluator->settings());
  outcome.summary.target = job.order.evaluator->settings().measuring.target;
  outcome.summary.calibration_hash = job.info->calibration_hash;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++scans_;
    welds_ += evaluation.result.hasWeld() ? 1 : 0;
    last_ = std::string(name(evaluation.result.kind)) +
            (evaluation.result.reason.empty() ? "" : ": " + evaluation.result.reason);
  }
  publish(scan, evaluation, outcome);
  if (!params_.output.empty())
    write(scan, evaluation, job, outcome);
  return outcome;
}

void WeldServer::publish(const Scan& scan, const WeldEvaluation& evaluation, WeldOutcome& outcome)
try
{
  summary_.publish(boost::make_shared<const WeldMeasurement>(outcome.summary));
  measured_.publish(boost::make_shared<const WeldMeasurement>(outcome.summary));
  markers_.publish(weldMarkers(evaluation, outcome.summary.header));
  if (const WeldSection* middle = middleSection(evaluation.result))
    section_marker_.publish(
        sectionMarkers(*middle, scan.rows[static_cast<std::size_t>(middle->row)], outcome.summary.header));
  grinding_.publish(scan, evaluation, outcome.summary);
}
catch (const InputError& error)
{
  outcome.trouble = error.what();
}

void WeldServer::write(const Scan& scan, const WeldEvaluation& evaluation, const Job& job, WeldOutcome& outcome)
try
{
  namespace fs = std::filesystem;
  const std::string folder =
      job.order.weld_id.empty() ? "scan_" + std::to_string(job.info->header.stamp.toNSec()) : job.order.weld_id;
  const fs::path directory = fs::absolute(fs::path(params_.output) / folder);
  fs::create_directories(directory);
  removeStaleFiles(directory.string(), FreshFiles{});
  const WeldRecordInfo info{ job.order.weld_id,
                             { job.info->calibration, job.info->calibration_hash, job.info->calibration_date } };
  outcome.files = writeWeldFiles(scan, evaluation, job.order.evaluator->settings(), info, directory.string());
  if (params_.report)
    for (const std::string& file : writeReport(directory.string()))
      outcome.files.push_back(file);
}
catch (const std::exception& error)
{
  outcome.trouble += (outcome.trouble.empty() ? "" : "; ") + std::string(error.what());
}

void WeldServer::diagnose(diagnostic_updater::DiagnosticStatusWrapper& status)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  status.add("scans measured", scans_);
  status.add("welds", welds_);
  status.add("scans lost", lost_);
  status.add("last", last_);
  if (lost_ > 0)
    status.summary(diagnostic_msgs::DiagnosticStatus::WARN, "scans came faster than they were measured");
  else
    status.summary(diagnostic_msgs::DiagnosticStatus::OK, scans_ == 0 ? "waiting for a scan" : last_);
}
}  // namespace weld_profiler
