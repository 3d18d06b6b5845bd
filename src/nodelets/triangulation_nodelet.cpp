#include <memory>
#include <string>

#include <dynamic_reconfigure/server.h>
#include <nodelet/nodelet.h>
#include <pluginlib/class_list_macros.hpp>

#include "load_guard.h"
#include "weld_profiler/TriangulationConfig.h"
#include "weld_profiler/ros/calibration_url.h"
#include "weld_profiler/ros/node_params.h"
#include "weld_profiler/ros/scan_server.h"

namespace weld_profiler
{
/// stripe, joint_states (or tf) -> profile_points, scan_points, and the services of a scan. See the class of the work,
/// ScanServer.
class TriangulationNodelet : public nodelet::Nodelet
{
private:
  void onInit() override
  {
    startOrExplain(getName(), [this] { start(); });
  }

  void start()
  {
    NodeParams params(getPrivateNodeHandle());
    std::string calibration;
    params.required("calibration", calibration, "the path or package:// URL of a calibration file");
    params_.visit(params);
    for (const std::string& name : params.unknown())
      NODELET_WARN_STREAM("parameter " << name << " is not one of this nodelet's and changes nothing");
    params_.validate();
    scans_ = std::make_unique<ScanServer>(
        ScanServer::Handles{ getNodeHandle(), getPrivateNodeHandle(), getMTNodeHandle(), getName() }, params_,
        loadCalibrationFrom(calibration), calibrationRecord(resolveUrl(calibration)));
    server_ = std::make_unique<dynamic_reconfigure::Server<TriangulationConfig>>(getPrivateNodeHandle());
    server_->setCallback([this](TriangulationConfig& config, std::uint32_t) { reconfigure(config); });
    scans_->subscribe();
  }

  /// Live knobs: taken whole or, if they do not validate, not at all.
  void reconfigure(TriangulationConfig& config)
  {
    ScanParams wanted = params_.chain.scan;
    wanted.trigger = config.trigger;
    wanted.pitch = config.pitch;
    wanted.min_x = config.min_x;
    wanted.max_x = config.max_x;
    wanted.min_y = config.min_y;
    wanted.max_y = config.max_y;
    wanted.min_z = config.min_z;
    wanted.max_z = config.max_z;
    try
    {
      scans_->use(wanted);
      params_.chain.scan = wanted;
    }
    catch (const ConfigError& error)
    {
      NODELET_ERROR_STREAM(error.what() << "; the settings stay as they were");
    }
    const ScanParams& scan = params_.chain.scan;
    config.trigger = scan.trigger;
    config.pitch = scan.pitch;
    config.min_x = scan.min_x;
    config.max_x = scan.max_x;
    config.min_y = scan.min_y;
    config.max_y = scan.max_y;
    config.min_z = scan.min_z;
    config.max_z = scan.max_z;
  }

  ScanServerParams params_;
  std::unique_ptr<ScanServer> scans_;
  std::unique_ptr<dynamic_reconfigure::Server<TriangulationConfig>> server_;
};
}  // namespace weld_profiler

PLUGINLIB_EXPORT_CLASS(weld_profiler::TriangulationNodelet, nodelet::Nodelet)
