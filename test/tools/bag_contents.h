#pragma once

#include <map>
#include <string>
#include <vector>

#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/JointState.h>
#include <tf2_msgs/TFMessage.h>

namespace weld_profiler
{
/// A scan's bag, read whole.
struct BagContents
{
  std::vector<sensor_msgs::ImageConstPtr> images;
  std::vector<sensor_msgs::CameraInfoConstPtr> infos;
  std::vector<sensor_msgs::JointStateConstPtr> joints;
  std::vector<tf2_msgs::TFMessageConstPtr> transforms;
  std::map<std::string, int> topics;
  bool times_are_stamps = true;  ///< each message's time in the bag is its header's stamp
};

inline BagContents readBag(const std::string& path)
{
  BagContents contents;
  rosbag::Bag bag(path, rosbag::bagmode::Read);
  rosbag::View view(bag);
  const auto check = [&](const rosbag::MessageInstance& instance, const std_msgs::Header& header)
  { contents.times_are_stamps = contents.times_are_stamps && instance.getTime() == header.stamp; };
  for (const rosbag::MessageInstance& instance : view)
  {
    ++contents.topics[instance.getTopic()];
    if (const auto image = instance.instantiate<sensor_msgs::Image>())
      check(instance, image->header), contents.images.push_back(image);
    else if (const auto info = instance.instantiate<sensor_msgs::CameraInfo>())
      check(instance, info->header), contents.infos.push_back(info);
    else if (const auto joint = instance.instantiate<sensor_msgs::JointState>())
      check(instance, joint->header), contents.joints.push_back(joint);
    else if (const auto transform = instance.instantiate<tf2_msgs::TFMessage>())
      check(instance, transform->transforms.at(0).header), contents.transforms.push_back(transform);
  }
  return contents;
}
}  // namespace weld_profiler
