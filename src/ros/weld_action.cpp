#include "weld_profiler/ros/weld_action.h"

#include <cmath>
#include <regex>

#include "weld_profiler/core/errors.h"
#include "weld_profiler/ros/origin.h"

namespace weld_profiler
{
namespace
{
constexpr double kFeedbackPeriod = 0.1;   // [s]
constexpr double kMeasuringTime = 120.0;  // measuring, files and report: longer is a fault [s]
constexpr double kLeastTravel = 1e-4;     // the stage has begun to move [m]

void requireId(const std::string& id)
{
  static const std::regex kName("[A-Za-z0-9_][A-Za-z0-9._-]{0,63}");
  requireWeldId(id);  // first: what is no text cannot be shown
  if (!id.empty() && !std::regex_match(id, kName))
    throw ConfigError("weld_id is '" + id + "', must be up to 64 letters, digits and . _ -, no . or - first");
}
}  // namespace

WeldAction::WeldAction(const ros::NodeHandle& node, const std::string& name, WeldServer& server)
  : node_(node),
    name_(name),
    server_(server),
    action_(
        node_, "scan_weld", [this](const ScanWeldGoalConstPtr& goal) { execute(goal); }, false)
{
}

WeldAction::~WeldAction()
{
  stopping_ = true;
  measured_.notify_all();
  action_.shutdown();
}

bool WeldAction::interrupted()
{
  return stopping_ || !ros::ok() || action_.isPreemptRequested();
}

void WeldAction::execute(const ScanWeldGoalConstPtr& goal)
{
  try
  {
    run(*goal);
  }
  catch (const std::exception& error)
  {
    abort(error.what());
  }
}

void WeldAction::abort(const std::string& message)
{
  ROS_ERROR_STREAM_NAMED(name_, "[" << name_ << "] scan_weld: " << message);
  ScanWeldResult result;
  result.message = message;
  action_.setAborted(result, message);
}

WeldOrder WeldAction::orderOf(const ScanWeldGoal& goal) const
{
  requireId(goal.weld_id);
  if (!(goal.travel >= 0.0))
    throw ConfigError("travel is " + std::to_string(goal.travel) + ", must be 0 (until the stage rests) or more [m]");
  WeldOrder order{ goal.weld_id, server_.params().settings };
  if (!goal.kind.empty())
    order.settings.measuring.kind = goal.kind;
  if (!goal.target.empty())
    order.settings.measuring.target = goal.target;
  if (goal.rest_height != 0.0)
    order.settings.measuring.rest_height = goal.rest_height;
  if (goal.thickness != 0.0)
    order.settings.judging.thickness = goal.thickness;
  if (!goal.level.empty())
    order.settings.judging.level = goal.level;
  order.settings.validate();
  return order;
}

void WeldAction::call(const char* service, bool must)
{
  std_srvs::Trigger trigger;
  const std::string name = node_.resolveName(service);
  if (!ros::service::call(name, trigger))
    throw PreconditionError("service " + name + " does not answer, is the triangulation nodelet loaded?");
  if (must && !trigger.response.success)
    throw PreconditionError("service " + name + ": " + trigger.response.message);
}

void WeldAction::run(const ScanWeldGoal& goal)
{
  const WeldOrder order = orderOf(goal);
  call("start_scan", true);
  outcome_.reset();
  server_.watch();
  if (!follow(goal))
  {
    call("stop_scan", false);
    ScanWeldResult result;
    result.message = "interrupted; the scan was stopped and not measured for this goal";
    action_.setPreempted(result, result.message);
    return;
  }
  server_.order(order,
                [this](const WeldOutcome& outcome)
                {
                  const std::lock_guard<std::mutex> lock(mutex_);
                  outcome_ = std::make_shared<const WeldOutcome>(outcome);
                  measured_.notify_all();
                });
  try
  {
    call("stop_scan", true);
  }
  catch (const PreconditionError&)
  {
    server_.cancelOrder();
    throw;
  }
  WeldOutcome outcome;
  if (!wait(outcome))
    return abort("the scan was not measured within " + std::to_string(static_cast<int>(kMeasuringTime)) + " s");
  finish(order, outcome);
}

/// Until the travel is done or the stage rests. @return false when somebody interrupts.
bool WeldAction::follow(const ScanWeldGoal& goal)
{
  for (;;)
  {
    if (interrupted())
      return false;
    const WeldServer::Travel travel = server_.travel();
    const double done = std::abs(travel.last - travel.first);
    ScanWeldFeedback feedback;
    feedback.profiles = travel.profiles;
    feedback.travel = done;
    feedback.age = travel.age;
    action_.publishFeedback(feedback);
    const bool rests = (ros::WallTime::now() - travel.moved).toSec() > server_.params().rest_time;
    if (goal.travel > 0.0 ? done >= goal.travel : done > kLeastTravel && rests)
      return true;
    ros::WallDuration(kFeedbackPeriod).sleep();
  }
}

bool WeldAction::wait(WeldOutcome& outcome)
{
  std::unique_lock<std::mutex> lock(mutex_);
  const auto until = std::chrono::steady_clock::now() + std::chrono::duration<double>(kMeasuringTime);
  measured_.wait_until(lock, until, [this] { return stopping_ || outcome_ != nullptr; });
  if (outcome_ != nullptr)
    outcome = *outcome_;
  return outcome_ != nullptr;
}

void WeldAction::finish(const WeldOrder& order, const WeldOutcome& outcome)
{
  ScanWeldResult result;
  result.summary = outcome.summary;
  result.files = outcome.files;
  const bool weld = outcome.summary.kind != name(WeldKind::None);
  const bool level = order.settings.judging.level.empty() || outcome.verdict.asked == Decision::Pass;
  result.success = weld && level && outcome.trouble.empty();
  result.message = outcome.summary.kind + (weld ? ", " + outcome.verdict.text() : "") +
                   (outcome.summary.reason.empty() ? "" : ": " + outcome.summary.reason) +
                   (outcome.trouble.empty() ? "" : "; " + outcome.trouble);
  action_.setSucceeded(result, result.message);
}
}  // namespace weld_profiler
