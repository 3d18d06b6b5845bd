#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <sensor_msgs/PointCloud2.h>

#include "weld_profiler/ScanInfo.h"
#include "weld_profiler/WeldMeasurement.h"
#include "weld_profiler/ros/grinding_output.h"
#include "weld_profiler/ros/travel_watch.h"
#include "weld_profiler/ros/weld_files.h"
#include "weld_profiler/ros/work_queue.h"
#include "weld_profiler/weld/live_weld.h"
#include "weld_profiler/weld/weld_evaluation.h"

namespace weld_profiler
{
/// Settings of the weld_measurement nodelet.
struct WeldServerParams
{
  WeldSettings settings;
  std::string output_frame;  ///< what grinding takes is given in this frame; empty = the cloud's
  std::string output;        ///< folder in which each scan gets one of its own; empty = nothing is written
  bool report = true;        ///< with output: report.html and report.png as well
  double rest_time = 1.0;    ///< ScanWeld: the stage is at rest after so long without travel [s], 0.1..60

  void validate() const;  ///< @throws ConfigError naming field, value and range

  template <class Visitor>
  void visit(Visitor&& v)
  {
    settings.visit(v);
    v("output_frame", output_frame);
    v("output", output);
    v("report", report);
    v("rest_time", rest_time);
  }
};

/// What is asked for one scan, beside the nodelet's own settings.
struct WeldOrder
{
  std::string weld_id;
  WeldSettings settings;
};

/// What became of a scan.
struct WeldOutcome
{
  WeldMeasurement summary;
  WeldVerdict verdict;
  std::vector<std::string> files;
  std::string trouble;  ///< what could not be written or given out; empty = nothing
};

/// Measures on topics: live sections from profile_points, all of a scan when scan_info says that it has ended.
/// Callbacks may come from any thread; the measuring of a scan has a thread of its own.
class WeldServer
{
public:
  struct Handles
  {
    ros::NodeHandle node;  ///< the profiler's namespace
    ros::NodeHandle own;   ///< private
    std::string name;
  };

  /// @throws ConfigError naming field, value and range; InputError for a table of limits that cannot be read.
  WeldServer(const Handles& handles, const WeldServerParams& params);
  ~WeldServer();

  /// Call last: from here on callbacks come.
  void subscribe();

  const WeldServerParams& params() const { return params_; }

  /// The next scan that ends is measured after this; `done` is called from the measuring thread.
  void order(const WeldOrder& order, std::function<void(const WeldOutcome&)> done);
  void cancelOrder();

  /// What has come since the last call of watch().
  using Travel = TravelWatch::Travel;
  void watch() { travel_.restart(); }
  Travel travel() const { return travel_.travel(); }

private:
  struct Order
  {
    std::shared_ptr<const WeldEvaluator> evaluator;
    std::string weld_id;
    std::function<void(const WeldOutcome&)> done;
  };
  struct Job
  {
    ScanInfoConstPtr info;
    Order order;
  };
  void onProfile(const sensor_msgs::PointCloud2ConstPtr& cloud);
  WeldSection measureLive(const Profile& profile);
  void onScanInfo(const ScanInfoConstPtr& info);
  void work();
  sensor_msgs::PointCloud2ConstPtr fetch(const ScanInfo& info);
  void measure(const Job& job);
  WeldOutcome evaluate(const Job& job, const sensor_msgs::PointCloud2& cloud);
  void publish(const Scan& scan, const WeldEvaluation& evaluation, WeldOutcome& outcome);
  void write(const Scan& scan, const WeldEvaluation& evaluation, const Job& job, WeldOutcome& outcome);
  void diagnose(diagnostic_updater::DiagnosticStatusWrapper& status);

  Handles handles_;
  const WeldServerParams params_;
  std::shared_ptr<const WeldEvaluator> evaluator_;
  GrindingOutput grinding_;
  ros::Publisher measured_, summary_, markers_, section_marker_;
  diagnostic_updater::Updater updater_;
  TravelWatch travel_;

  std::mutex live_mutex_;  // guards live_
  LiveWeld live_;          ///< of the scan that is running

  mutable std::mutex mutex_;  // guards up to the queue
  Order order_;
  std::uint64_t scans_ = 0, welds_ = 0, lost_ = 0;
  std::string last_;  ///< what was measured last, one line

  WorkQueue<Job> queue_;
  ros::CallbackQueue fetched_;
  std::atomic<bool> stopping_{ false };
  std::thread worker_;
  std::vector<ros::Subscriber> subscribers_;
  ros::WallTimer second_;
};
}  // namespace weld_profiler
