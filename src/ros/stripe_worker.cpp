#include "weld_profiler/ros/stripe_worker.h"

#include <sensor_msgs/image_encodings.h>
#include <std_msgs/UInt64MultiArray.h>
#include <opencv2/core/mat.hpp>

#include "weld_profiler/core/errors.h"
#include "weld_profiler/ros/diagnostics.h"
#include "weld_profiler/ros/messages.h"
#include "weld_profiler/stripe/overlay.h"

namespace weld_profiler
{
namespace
{
constexpr double kLogPeriod = 5.0;  // seconds between two lines about the same trouble
}

void StripeWorkerParams::validate() const
{
  requireRange("stripe/queue_size", queue_size, 1, 10000, "images");
  requireRange("stripe/overlay_scale", overlay_scale, 1, 8);
}

StripeWorker::StripeWorker(ros::NodeHandle& node, ros::NodeHandle& own, const StripeParams& params,
                           const StripeWorkerParams& work, const std::string& name)
  : work_((work.validate(), work)),
    name_(name),
    updater_(node, own, name),
    queue_(static_cast<std::size_t>(work.queue_size), work.lossless),
    stage_(std::make_shared<const StripeStage>(params))
{
  stripes_ = node.advertise<StripeProfile>("stripe", 64);
  overlay_ = image_transport::ImageTransport(node).advertise("stripe_image", 1);
  if (work_.trace_pixels)
    pixels_ = node.advertise<std_msgs::UInt64MultiArray>("pixels_read", 1000);
  updater_.setHardwareID("none");
  updater_.add("stripe centre", this, &StripeWorker::diagnose);
  diagnostics_timer_ =
      node.createWallTimer(ros::WallDuration(1.0), [this](const ros::WallTimerEvent&) { updater_.force_update(); });
  thread_ = std::thread([this] { run(); });
}

StripeWorker::~StripeWorker()
{
  diagnostics_timer_.stop();
  queue_.close();
  thread_.join();
}

void StripeWorker::use(const StripeParams& params)
{
  auto stage = std::make_shared<const StripeStage>(params);
  const std::lock_guard<std::mutex> lock(mutex_);
  stage_ = std::move(stage);
}

void StripeWorker::onImage(const sensor_msgs::ImageConstPtr& image)
{
  countGap(*image);
  {
    const std::lock_guard<std::mutex> lock(mutex_);  // before the worker can count it out
    ++balance_.frames_in;
  }
  const std::size_t lost = queue_.push(image);
  if (lost > 0)
    drop("queue_full", lost);
}

void StripeWorker::onCameraInfo(const sensor_msgs::CameraInfoConstPtr& info)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  info_ = info;
}

void StripeWorker::onScanStarted(const std_msgs::HeaderConstPtr&)
{
  reset_ = true;
}

/// A gap in the driver's counter: images that were published and never came here.
void StripeWorker::countGap(const sensor_msgs::Image& image)
{
  const std::uint32_t seq = image.header.seq;
  if (last_seq_ && seq > *last_seq_ + 1)
    drop("lost_before_arrival", seq - *last_seq_ - 1);
  last_seq_ = seq;
}

void StripeWorker::drop(const char* reason, std::uint64_t frames)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  if (std::string(reason) == "lost_before_arrival")
    balance_.frames_in += frames;
  balance_.dropped[reason] += frames;
}

void StripeWorker::run()
{
  sensor_msgs::ImageConstPtr image;
  while (queue_.pop(image))
  {
    process(image);
    image.reset();
  }
}

void StripeWorker::process(const sensor_msgs::ImageConstPtr& image)
{
  if (reset_.exchange(false))
    workspace_.reset();
  workspace_.keep_trace = overlay_.getNumSubscribers() > 0;
  if (!extract(*image))
    return;
  if (workspace_.keep_trace)
    publishOverlay(*image);
  publishStripe(*image);
}

bool StripeWorker::extract(const sensor_msgs::Image& image)
{
  std::shared_ptr<const StripeStage> stage;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stage = stage_;
  }
  method_ = stage->params().method;
  try
  {
    const RawImage raw = rawImage(image);
    stage->process(raw, workspace_, stripe_);
    if (work_.trace_pixels)
    {
      std_msgs::UInt64MultiArray trace;
      trace.data = { image.header.seq, reinterpret_cast<std::uintptr_t>(raw.data) };
      pixels_.publish(trace);
    }
    return true;
  }
  catch (const std::exception& error)
  {
    drop("bad_image", 1);
    ROS_ERROR_STREAM_THROTTLE_NAMED(kLogPeriod, name_,
                                    "[" << name_ << "] " << error.what() << "; the frame is dropped");
    return false;
  }
}

void StripeWorker::publishOverlay(const sensor_msgs::Image& image)
{
  const cv::Mat picture = drawStripe(rawImage(image), stripe_, workspace_.initial, work_.overlay_scale);
  auto message = boost::make_shared<sensor_msgs::Image>();
  message->header = image.header;
  message->width = static_cast<std::uint32_t>(picture.cols);
  message->height = static_cast<std::uint32_t>(picture.rows);
  message->step = static_cast<std::uint32_t>(picture.cols * 3);
  message->encoding = sensor_msgs::image_encodings::BGR8;
  message->data.resize(static_cast<std::size_t>(message->step) * message->height);
  cv::Mat into(picture.rows, picture.cols, CV_8UC3, message->data.data(), message->step);
  picture.copyTo(into);
  overlay_.publish(sensor_msgs::ImageConstPtr(message));
}

void StripeWorker::publishStripe(const sensor_msgs::Image& image)
{
  const boost::shared_ptr<StripeProfile> message = pool_.take();
  message->header = image.header;
  message->header.seq = ++out_seq_;
  message->frame = image.header.seq;
  message->image_width = image.width;
  message->image_height = image.height;
  message->method = method_;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const sensor_msgs::CameraInfo unknown;
    const sensor_msgs::CameraInfo& info = info_ ? *info_ : unknown;
    message->roi_x = info.roi.x_offset;
    message->roi_y = info.roi.y_offset;
    message->binning_x = static_cast<std::uint8_t>(info.binning_x);
    message->binning_y = static_cast<std::uint8_t>(info.binning_y);
    ++stripes_out_;
    if (stripe_.empty())
      ++balance_.no_stripe;
  }
  swapStripe(stripe_, *message);
  const ros::Time now = ros::Time::now();
  age_.add((now - message->header.stamp).toSec(), now.toSec());
  stripes_.publish(boost::shared_ptr<const StripeProfile>(message));
}

void StripeWorker::diagnose(diagnostic_updater::DiagnosticStatusWrapper& status)
{
  status.summary(diagnostic_msgs::DiagnosticStatus::OK, "running");
  const std::lock_guard<std::mutex> lock(mutex_);
  status.add("method", stage_->params().method);
  reportAge(age_.summary(), status);
  status.add("frames in", balance_.frames_in);
  status.add("stripes out", stripes_out_);
  status.add("no stripe", balance_.no_stripe);
  status.add("waiting", balance_.frames_in - stripes_out_ - balance_.droppedTotal());
  status.add("dropped", balance_.droppedTotal());
  for (const auto& reason : balance_.dropped)
    status.add("dropped " + reason.first, reason.second);
  if (balance_.frames_in == 0)
    status.mergeSummary(diagnostic_msgs::DiagnosticStatus::WARN, "no images");
  if (balance_.droppedTotal() > 0)
    status.mergeSummary(diagnostic_msgs::DiagnosticStatus::WARN, "images dropped");
}
}  // namespace weld_profiler
