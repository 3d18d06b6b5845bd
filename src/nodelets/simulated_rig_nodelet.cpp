#include <memory>
#include <string>

#include <nodelet/nodelet.h>
#include <pluginlib/class_list_macros.hpp>

#include "load_guard.h"
#include "rig_player.h"
#include "weld_profiler/ros/node_params.h"

namespace weld_profiler
{
/// Publishes image_raw, camera_info and joint_states (or tf) of one simulated scan, in real time. See RigPlayer.
class SimulatedRigNodelet : public nodelet::Nodelet
{
private:
  void onInit() override
  {
    startOrExplain(getName(),
                   [this]
                   {
                     NodeParams params(getPrivateNodeHandle());
                     RigPlayerParams rig;
                     rig.visit(params);
                     for (const std::string& name : params.unknown())
                       NODELET_WARN_STREAM("parameter " << name << " is not one of this nodelet's and changes nothing");
                     player_ = std::make_unique<RigPlayer>(getNodeHandle(), getPrivateNodeHandle(), rig, getName());
                   });
  }

  std::unique_ptr<RigPlayer> player_;
};
}  // namespace weld_profiler

PLUGINLIB_EXPORT_CLASS(weld_profiler::SimulatedRigNodelet, nodelet::Nodelet)
