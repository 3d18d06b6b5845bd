#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>

#include <actionlib/server/simple_action_server.h>
#include <std_srvs/Trigger.h>

#include "weld_profiler/ScanWeldAction.h"
#include "weld_profiler/ros/weld_server.h"

namespace weld_profiler
{
/// The action `scan_weld`: starts a scan, follows it, ends it, waits for what was measured. One goal at a time; a new
/// one preempts it.
class WeldAction
{
public:
  /// @param server  outlives this object.
  WeldAction(const ros::NodeHandle& node, const std::string& name, WeldServer& server);
  ~WeldAction();

  void start() { action_.start(); }

private:
  void execute(const ScanWeldGoalConstPtr& goal);
  void run(const ScanWeldGoal& goal);
  WeldOrder orderOf(const ScanWeldGoal& goal) const;
  void call(const char* service, bool must);
  bool follow(const ScanWeldGoal& goal);
  bool wait(WeldOutcome& outcome);
  void finish(const WeldOrder& order, const WeldOutcome& outcome);
  void abort(const std::string& message);
  bool interrupted();

  ros::NodeHandle node_;
  const std::string name_;
  WeldServer& server_;
  std::mutex mutex_;
  std::condition_variable measured_;
  std::shared_ptr<const WeldOutcome> outcome_;
  std::atomic<bool> stopping_{ false };
  actionlib::SimpleActionServer<ScanWeldAction> action_;
};
}  // namespace weld_profiler
