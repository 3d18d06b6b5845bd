#pragma once

#include <vector>

#include <ros/ros.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/JointState.h>
#include <boost/make_shared.hpp>

#include "weld_profiler/core/frame.h"
#include "weld_profiler/ros/messages.h"
#include "weld_profiler/simulation/simulated_scan.h"

namespace weld_profiler
{
/// Publishes the frames and encoder samples of a simulated scan, as fast as asked, with the scan's own stamps.
class RigFeed
{
public:
  RigFeed(const std::string& name_space, const SceneParams& scene) : scan_(scene), encoder_(scan_.encoder())
  {
    images_ = node_.advertise<sensor_msgs::Image>(name_space + "/image_raw", 1000);
    infos_ = node_.advertise<sensor_msgs::CameraInfo>(name_space + "/camera_info", 1000);
    joints_ = node_.advertise<sensor_msgs::JointState>(name_space + "/joint_states", 10000);
  }

  const SimulatedScan& scan() const { return scan_; }

  bool connected() const { return images_.getNumSubscribers() > 0 && joints_.getNumSubscribers() > 0; }

  /// Encoder samples up to a stamp.
  void publishEncoder(Stamp until)
  {
    for (; next_sample_ < encoder_.size() && encoder_[next_sample_].stamp <= until; ++next_sample_)
      publishSample(encoder_[next_sample_].stamp, encoder_[next_sample_].position);
  }

  void publishSample(Stamp stamp, double position)
  {
    joints_.publish(boost::make_shared<sensor_msgs::JointState>(
        jointStateMessage(stamp, scan_.calibration().stage.joint, position)));
  }

  sensor_msgs::ImagePtr image(int index) const
  {
    Frame frame;
    scan_.render(index, frame.pixels);
    frame.width = scan_.width();
    frame.height = scan_.height();
    frame.step = scan_.step();
    frame.encoding = scan_.encoding();
    frame.stamp = scan_.stamp(index);
    frame.number = static_cast<std::uint64_t>(index) + 1;
    return imageMessage(std::move(frame), "camera_optical_frame");
  }

  void publish(const sensor_msgs::ImagePtr& image)
  {
    const auto info = boost::make_shared<sensor_msgs::CameraInfo>(cameraInfoMessage(scan_.calibration().camera));
    info->header = image->header;
    infos_.publish(info);
    images_.publish(image);
  }

  /// A frame and the encoder samples that bracket it.
  void publishFrame(int index)
  {
    publishEncoder(scan_.stamp(index) + fromSeconds(0.01));
    publish(image(index));
  }

private:
  SimulatedScan scan_;
  std::vector<SimulatedEncoderSample> encoder_;
  std::size_t next_sample_ = 0;
  ros::NodeHandle node_;
  ros::Publisher images_;
  ros::Publisher infos_;
  ros::Publisher joints_;
};
}  // namespace weld_profiler
