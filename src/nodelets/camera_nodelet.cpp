#include <atomic>
#include <chrono>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include <camera_info_manager/camera_info_manager.h>
#include <diagnostic_updater/diagnostic_updater.h>
#include <image_transport/image_transport.h>
#include <nodelet/nodelet.h>
#include <std_msgs/UInt64MultiArray.h>
#include <pluginlib/class_list_macros.hpp>

#include "load_guard.h"
#include "weld_profiler/camera/folder_source.h"
#include "weld_profiler/ros/calibration_url.h"
#include "weld_profiler/ros/messages.h"
#include "weld_profiler/ros/node_params.h"

namespace weld_profiler
{
/// Publishes the images of a FrameSource with camera_info. The source is read on a thread of its own.
class CameraNodelet : public nodelet::Nodelet
{
public:
  ~CameraNodelet() override
  {
    stop_ = true;
    if (thread_.joinable())
      thread_.join();
  }

private:
  void onInit() override
  {
    startOrExplain(getName(), [this] { start(); });
  }

  void start()
  {
    ros::NodeHandle& node = getNodeHandle();
    NodeParams params(getPrivateNodeHandle());
    std::string source = "folder", camera_info_url, camera_name = "camera", calibration;
    params("source", source);
    params("frame_id", frame_id_);
    params("camera_info_url", camera_info_url);
    params("camera_name", camera_name);
    params("calibration", calibration);
    params("trace_pixels", trace_pixels_);
    FolderSourceParams folder;
    folder.visit(params);
    for (const std::string& name : params.unknown())
      NODELET_WARN_STREAM("parameter " << name << " is not one of this nodelet's and changes nothing");
    requireOneOf("camera/source", source, std::vector<std::string>{ "folder" });
    source_ = std::make_unique<FolderSource>(folder);

    info_ = std::make_unique<camera_info_manager::CameraInfoManager>(node, camera_name, camera_info_url);
    if (!calibration.empty())
      info_->setCameraInfo(cameraInfoMessage(loadCalibrationFrom(calibration).camera));
    publisher_ = image_transport::ImageTransport(node).advertiseCamera("image_raw", 8);
    if (trace_pixels_)
      pixels_ = node.advertise<std_msgs::UInt64MultiArray>("pixels_published", 1000);
    updater_ = std::make_unique<diagnostic_updater::Updater>(node, getPrivateNodeHandle(), getName());
    updater_->setHardwareID(folder.images);
    updater_->add("camera", this, &CameraNodelet::diagnose);
    timer_ =
        node.createWallTimer(ros::WallDuration(1.0), [this](const ros::WallTimerEvent&) { updater_->force_update(); });
    thread_ = std::thread([this] { capture(); });
  }

  void capture()
  {
    while (!stop_)
    {
      Frame frame;
      switch (source_->next(frame, 0.1))
      {
        case FrameSource::Result::Frame:
          publish(std::move(frame));
          break;
        case FrameSource::Result::Timeout:
          break;
        case FrameSource::Result::Failed:
          ++failed_;
          NODELET_ERROR_STREAM(source_->message());
          break;
        case FrameSource::Result::End:
          ended_ = true;
          NODELET_INFO_STREAM("the last image is published, " << published_ << " in all");
          return;
      }
    }
  }

  void publish(Frame&& frame)
  {
    const sensor_msgs::ImagePtr image = imageMessage(std::move(frame), frame_id_);
    const auto info = boost::make_shared<sensor_msgs::CameraInfo>(info_->getCameraInfo());
    if (info->width == 0)
    {
      info->width = image->width;
      info->height = image->height;
    }
    info->header = image->header;
    if (trace_pixels_)
    {
      std_msgs::UInt64MultiArray trace;
      trace.data = { image->header.seq, reinterpret_cast<std::uintptr_t>(image->data.data()) };
      pixels_.publish(trace);
    }
    publisher_.publish(image, info);
    ++published_;
  }

  void diagnose(diagnostic_updater::DiagnosticStatusWrapper& status)
  {
    status.summary(diagnostic_msgs::DiagnosticStatus::OK, ended_ ? "all images published" : "running");
    status.add("frames published", published_.load());
    status.add("frames failed", failed_.load());
    status.add("calibrated", info_->isCalibrated());
    if (failed_ > 0)
      status.mergeSummary(diagnostic_msgs::DiagnosticStatus::WARN, "images could not be read");
    if (published_ == 0)
      status.mergeSummary(diagnostic_msgs::DiagnosticStatus::WARN, "no images yet");
  }

  std::string frame_id_ = "camera_optical_frame";
  bool trace_pixels_ = false;
  std::unique_ptr<FrameSource> source_;
  std::unique_ptr<camera_info_manager::CameraInfoManager> info_;
  image_transport::CameraPublisher publisher_;
  ros::Publisher pixels_;
  std::unique_ptr<diagnostic_updater::Updater> updater_;
  ros::WallTimer timer_;
  std::atomic<std::uint64_t> published_{ 0 };
  std::atomic<std::uint64_t> failed_{ 0 };
  std::atomic<bool> ended_{ false };
  std::atomic<bool> stop_{ false };
  std::thread thread_;
};
}  // namespace weld_profiler

PLUGINLIB_EXPORT_CLASS(weld_profiler::CameraNodelet, nodelet::Nodelet)
