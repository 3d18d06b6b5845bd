// What a ScanServer answers: services and diagnostics.
#include <algorithm>
#include <filesystem>

#include <std_msgs/Header.h>

#include "weld_profiler/core/errors.h"
#include "weld_profiler/ros/diagnostics.h"
#include "weld_profiler/ros/messages.h"
#include "weld_profiler/ros/origin.h"
#include "weld_profiler/ros/scan_server.h"
#include "weld_profiler/scan/export.h"

namespace weld_profiler
{
namespace
{
constexpr double kEncoderSilent = 1.0;  // an encoder without a sample for longer is reported [s]
}

bool ScanServer::startScan(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  chain_->builder().restart();
  chain_->builder().setScanning(true);
  last_stripe_seq_ = 0;
  announceStart();
  response.success = true;
  response.message = "scanning";
  return true;
}

bool ScanServer::stopScan(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!chain_->builder().scanning())
  {
    response.success = false;
    response.message = "no scan is open, call start_scan first";
    return true;
  }
  chain_->builder().finish();
  chain_->builder().setScanning(false);
  const FrameBalance& balance = chain_->builder().balance();
  response.success = true;
  response.message = std::to_string(balance.rows) + " rows of " + std::to_string(balance.frames_in) + " frames";
  return true;
}

std::shared_ptr<const Scan> ScanServer::scanToSave()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!chain_->builder().openScan().empty())
    return std::make_shared<const Scan>(chain_->builder().openScan());
  return last_scan_;
}

bool ScanServer::saveScanFile(SaveScan::Request& request, SaveScan::Response& response)
{
  response.success = false;
  try
  {
    const std::shared_ptr<const Scan> scan = scanToSave();
    if (!scan)
      throw InputError("there is no scan yet, nothing to save to " + request.path);
    std::string format = request.format;
    if (format.empty())
      format = request.path.substr(std::min(request.path.size(), request.path.rfind('.') + 1));
    saveScan(*scan, request.path, format, Origin{ "", scan->frame_id, record_.hash, yamlOf(params_.chain) }.comments());
    response.success = true;
    response.message =
        std::to_string(scan->rows.size()) + " rows in " + std::filesystem::absolute(request.path).string();
  }
  catch (const std::exception& error)
  {
    response.message = error.what();
    ROS_ERROR_STREAM_NAMED(handles_.name, "[" << handles_.name << "] " << error.what());
  }
  return true;
}

/// Tells the other stages of the chain to forget what they learnt.
void ScanServer::announceStart()
{
  std_msgs::Header header;
  header.stamp = ros::Time::now();
  header.frame_id = chain_->cloudFrame();
  started_.publish(header);
}

void ScanServer::diagnose(diagnostic_updater::DiagnosticStatusWrapper& status)
{
  using diagnostic_msgs::DiagnosticStatus;
  const std::lock_guard<std::mutex> lock(mutex_);
  const ScanBuilder& builder = chain_->builder();
  status.summary(DiagnosticStatus::OK, builder.scanning() ? "scanning" : "idle");
  reportAge(age_.summary(), status);
  reportBalance(builder.balance(), builder.waiting(), status);
  status.add("scans ended", scans_ended_);
  status.add("rows of the open scan", builder.openScan().rows.size());
  if (last_scan_ && last_scan_->end == ScanEnd::MaxRows)
    status.mergeSummary(DiagnosticStatus::WARN, "max_rows closed the last scan");
  const EncoderTrack* encoder = chain_->encoder();
  if (encoder == nullptr)
    return;
  if (encoder->empty())
    status.mergeSummary(DiagnosticStatus::WARN, joint_messages_ == 0 ? "no joint_states" : "joint not in joint_states");
  else
  {
    const double silent = (ros::Time::now() - toRosTime(encoder->latestStamp())).toSec();
    status.addf("encoder age [ms]", "%.1f", 1e3 * silent);
    if (silent > kEncoderSilent)
      status.mergeSummaryf(DiagnosticStatus::WARN, "no encoder sample for %.1f s", silent);
    status.addf("encoder position [m]", "%.7f", encoder->latestPosition());
    status.addf("encoder speed [m/s]", "%.6f", silent > kEncoderSilent ? 0.0 : encoder->speed());
  }
}
}  // namespace weld_profiler
