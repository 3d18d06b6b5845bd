#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include <diagnostic_updater/diagnostic_updater.h>
#include <image_transport/image_transport.h>
#include <ros/node_handle.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <std_msgs/Header.h>

#include "weld_profiler/StripeProfile.h"
#include "weld_profiler/core/balance.h"
#include "weld_profiler/ros/age_statistics.h"
#include "weld_profiler/ros/message_pool.h"
#include "weld_profiler/ros/work_queue.h"
#include "weld_profiler/stripe/stripe_stage.h"

namespace weld_profiler
{
/// Settings of the stripe nodelet beside StripeParams.
struct StripeWorkerParams
{
  bool lossless = false;      ///< replay: wait instead of dropping the oldest image
  int queue_size = 64;        ///< images that may wait, 1..10000
  int overlay_scale = 1;      ///< enlargement of stripe_image, 1..8
  bool trace_pixels = false;  ///< publish the address of each image's pixels on pixels_read (proof of zero copy)

  void validate() const;  ///< @throws ConfigError naming field, value and range

  template <class Visitor>
  void visit(Visitor&& v)
  {
    v("lossless", lossless);
    v("queue_size", queue_size);
    v("overlay_scale", overlay_scale);
    v("trace_pixels", trace_pixels);
  }
};

/// Images in, stripes out, on a thread of its own: queue, extraction, publishing, counting.
/// Callbacks may come from any thread. Destroying it joins the thread; images still waiting are let go.
class StripeWorker
{
public:
  /// @throws ConfigError naming field, value and range.
  StripeWorker(ros::NodeHandle& node, ros::NodeHandle& own, const StripeParams& params, const StripeWorkerParams& work,
               const std::string& name);
  ~StripeWorker();

  /// Swaps in a stage built from params; a frame under way ends with the old one.
  void use(const StripeParams& params);

  void onImage(const sensor_msgs::ImageConstPtr& image);
  void onCameraInfo(const sensor_msgs::CameraInfoConstPtr& info);
  void onScanStarted(const std_msgs::HeaderConstPtr& header);

private:
  void run();
  void process(const sensor_msgs::ImageConstPtr& image);
  void countGap(const sensor_msgs::Image& image);
  bool extract(const sensor_msgs::Image& image);
  void publishOverlay(const sensor_msgs::Image& image);
  void publishStripe(const sensor_msgs::Image& image);
  void drop(const char* reason, std::uint64_t frames);
  void diagnose(diagnostic_updater::DiagnosticStatusWrapper& status);

  const StripeWorkerParams work_;
  const std::string name_;
  ros::Publisher stripes_;
  ros::Publisher pixels_;
  image_transport::Publisher overlay_;
  diagnostic_updater::Updater updater_;
  ros::WallTimer diagnostics_timer_;
  WorkQueue<sensor_msgs::ImageConstPtr> queue_;

  std::mutex mutex_;  // guards what callbacks and the worker share: stage_, info_, balance_
  std::shared_ptr<const StripeStage> stage_;
  sensor_msgs::CameraInfoConstPtr info_;
  FrameBalance balance_;
  std::uint64_t stripes_out_ = 0;
  std::atomic<bool> reset_{ false };

  // the worker's own
  MessagePool<StripeProfile> pool_;
  Workspace workspace_;
  Stripe stripe_;
  std::string method_;
  std::optional<std::uint32_t> last_seq_;
  std::uint32_t out_seq_ = 0;
  AgeStatistics age_;
  std::thread thread_;
};
}  // namespace weld_profiler
