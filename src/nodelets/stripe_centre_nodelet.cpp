#include <memory>
#include <string>

#include <dynamic_reconfigure/server.h>
#include <image_transport/image_transport.h>
#include <nodelet/nodelet.h>
#include <pluginlib/class_list_macros.hpp>

#include "load_guard.h"
#include "weld_profiler/StripeCentreConfig.h"
#include "weld_profiler/ros/node_params.h"
#include "weld_profiler/ros/stripe_worker.h"

namespace weld_profiler
{
/// image_raw, camera_info -> stripe, stripe_image. See the class of the work, StripeWorker.
class StripeCentreNodelet : public nodelet::Nodelet
{
public:
  ~StripeCentreNodelet() override
  {
    server_.reset();  // no callback may meet a worker that is gone
    images_.shutdown();
    info_.shutdown();
    reset_.shutdown();
    worker_.reset();
  }

private:
  void onInit() override
  {
    startOrExplain(getName(), [this] { start(); });
  }

  void start()
  {
    ros::NodeHandle& node = getNodeHandle();
    ros::NodeHandle& own = getPrivateNodeHandle();
    NodeParams params(own);
    params_.visit(params);
    StripeWorkerParams work;
    work.visit(params);
    for (const std::string& name : params.unknown())
      NODELET_WARN_STREAM("parameter " << name << " is not one of this nodelet's and changes nothing");
    params_.validate();
    worker_ = std::make_unique<StripeWorker>(node, own, params_, work, getName());
    server_ = std::make_unique<dynamic_reconfigure::Server<StripeCentreConfig>>(own);
    server_->setCallback([this](StripeCentreConfig& config, std::uint32_t) { reconfigure(config); });

    const std::uint32_t queue = work.lossless ? 0 : 64;
    info_ = node.subscribe("camera_info", queue, &StripeWorker::onCameraInfo, worker_.get());
    reset_ = node.subscribe("scan_started", 1, &StripeWorker::onScanStarted, worker_.get());
    images_ = image_transport::ImageTransport(node).subscribe("image_raw", queue, &StripeWorker::onImage, worker_.get(),
                                                              image_transport::TransportHints("raw"));
  }

  /// Live knobs: a new stage is built and swapped in; one that cannot be built is refused and the old one stays.
  void reconfigure(StripeCentreConfig& config)
  {
    StripeParams wanted = params_;
    wanted.method = config.method;
    wanted.fit = config.fit;
    wanted.channel = config.channel;
    wanted.min_peak_counts = config.min_peak_counts;
    wanted.min_stripe_width_px = config.min_stripe_width_px;
    wanted.max_stripe_width_px = config.max_stripe_width_px;
    wanted.max_gap_px = config.max_gap_px;
    wanted.roi_x = config.roi_x;
    wanted.roi_y = config.roi_y;
    wanted.roi_width = config.roi_width;
    wanted.roi_height = config.roi_height;
    try
    {
      worker_->use(wanted);
      params_ = wanted;
    }
    catch (const ConfigError& error)
    {
      NODELET_ERROR_STREAM(error.what() << "; the settings stay as they were");
    }
    config.method = params_.method;
    config.fit = params_.fit;
    config.channel = params_.channel;
    config.min_peak_counts = params_.min_peak_counts;
    config.min_stripe_width_px = params_.min_stripe_width_px;
    config.max_stripe_width_px = params_.max_stripe_width_px;
    config.max_gap_px = params_.max_gap_px;
    config.roi_x = params_.roi_x;
    config.roi_y = params_.roi_y;
    config.roi_width = params_.roi_width;
    config.roi_height = params_.roi_height;
  }

  StripeParams params_;
  std::unique_ptr<StripeWorker> worker_;
  std::unique_ptr<dynamic_reconfigure::Server<StripeCentreConfig>> server_;
  ros::Subscriber info_;
  ros::Subscriber reset_;
  image_transport::Subscriber images_;
};
}  // namespace weld_profiler

PLUGINLIB_EXPORT_CLASS(weld_profiler::StripeCentreNodelet, nodelet::Nodelet)
