#include <memory>

#include <nodelet/nodelet.h>
#include <pluginlib/class_list_macros.hpp>

#include "load_guard.h"
#include "weld_profiler/ros/node_params.h"
#include "weld_profiler/ros/weld_action.h"
#include "weld_profiler/ros/weld_server.h"

namespace weld_profiler
{
/// profile_points, scan_points -> weld, weld_points, markers, what grinding takes, and the action scan_weld. See the
/// classes of the work, WeldServer and WeldAction.
class WeldMeasurementNodelet : public nodelet::Nodelet
{
private:
  void onInit() override
  {
    startOrExplain(getName(), [this] { start(); });
  }

  void start()
  {
    NodeParams params(getPrivateNodeHandle());
    WeldServerParams wanted;
    wanted.visit(params);
    for (const std::string& name : params.unknown())
      NODELET_WARN_STREAM("parameter " << name << " is not one of this nodelet's and changes nothing");
    server_ = std::make_unique<WeldServer>(WeldServer::Handles{ getMTNodeHandle(), getPrivateNodeHandle(), getName() },
                                           wanted);
    action_ = std::make_unique<WeldAction>(getMTNodeHandle(), getName(), *server_);
    server_->subscribe();
    action_->start();
  }

  std::unique_ptr<WeldServer> server_;
  std::unique_ptr<WeldAction> action_;  // last: gone first
};
}  // namespace weld_profiler

PLUGINLIB_EXPORT_CLASS(weld_profiler::WeldMeasurementNodelet, nodelet::Nodelet)
