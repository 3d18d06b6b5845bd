#pragma once

#include <memory>
#include <mutex>
#include <string>

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/node_handle.h>
#include <std_srvs/Trigger.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_broadcaster.h>
#include <tf2_ros/transform_listener.h>

#include "weld_profiler/SaveScan.h"
#include "weld_profiler/ScanInfo.h"
#include "weld_profiler/ros/age_statistics.h"
#include "weld_profiler/ros/scan_chain.h"
#include "weld_profiler/ros/weld_files.h"

namespace weld_profiler
{
/// Settings of the triangulation nodelet.
struct ScanServerParams
{
  ScanChainParams chain;
  bool auto_start = true;  ///< a scan starts by itself; else with start_scan
  bool lossless = false;   ///< replay: nothing is dropped, whatever it takes

  void validate() const;  ///< @throws ConfigError naming field, value and range

  template <class Visitor>
  void visit(Visitor&& v)
  {
    chain.visit(v);
    v("auto_start", auto_start);
    v("lossless", lossless);
  }
};

/// The ScanChain on its topics: subscriptions, clouds, services, tf, diagnostics. Callbacks may come from any thread.
class ScanServer
{
public:
  struct Handles
  {
    ros::NodeHandle node;      ///< the profiler's namespace: topics and services
    ros::NodeHandle own;       ///< private
    ros::NodeHandle services;  ///< multi-threaded, so that saving holds up no frame
    std::string name;
  };

  /// @throws ConfigError naming field, value and range.
  /// @param record  names the calibration in scan_info.
  ScanServer(const Handles& handles, const ScanServerParams& params, const Calibration& calibration,
             const CalibrationRecord& record);
  ~ScanServer();

  /// Call last: from here on callbacks come.
  void subscribe();

  /// New live settings (trigger, pitch, window). @throws ConfigError; the old ones stay.
  void use(const ScanParams& params);

private:
  void onStripe(const StripeProfileConstPtr& stripe);
  void onCameraInfo(const sensor_msgs::CameraInfoConstPtr& info);
  void onJoints(const sensor_msgs::JointStateConstPtr& joints);
  void onProfile(const Profile& profile);
  void onScan(Scan&& scan);
  ScanInfoConstPtr scanInfo(const std_msgs::Header& header, const Scan& scan) const;
  void onPoll();
  void onSecond();
  bool startScan(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  bool stopScan(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  bool saveScanFile(SaveScan::Request& request, SaveScan::Response& response);
  std::shared_ptr<const Scan> scanToSave();
  void announceStart();
  void broadcastScanFrame();
  void sayProblem();
  void countGap(const StripeProfile& stripe);
  void diagnose(diagnostic_updater::DiagnosticStatusWrapper& status);

  Handles handles_;
  const ScanServerParams params_;
  const CalibrationRecord record_;
  tf2_ros::Buffer transforms_;
  std::unique_ptr<tf2_ros::TransformListener> listener_;
  tf2_ros::TransformBroadcaster broadcaster_;
  ros::Publisher profiles_;
  ros::Publisher scans_;
  ros::Publisher started_;
  ros::Publisher ended_;
  diagnostic_updater::Updater updater_;

  std::mutex mutex_;  // guards everything below
  std::unique_ptr<ScanChain> chain_;
  std::shared_ptr<const Scan> last_scan_;
  std::size_t scans_ended_ = 0;
  std::size_t published_rows_ = 0;
  std::string camera_frame_;
  std::uint32_t last_stripe_seq_ = 0;
  std::uint64_t joint_messages_ = 0;
  bool joint_found_ = false;
  AgeStatistics age_;

  std::vector<ros::ServiceServer> services_;
  std::vector<ros::WallTimer> timers_;
  std::vector<ros::Subscriber> subscribers_;  // last: gone first, so that no callback meets what is being taken down
};
}  // namespace weld_profiler
