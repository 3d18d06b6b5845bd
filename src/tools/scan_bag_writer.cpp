#include "tools/scan_bag_writer.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <geometry_msgs/TransformStamped.h>
#include <tf2_msgs/TFMessage.h>

#include "weld_profiler/core/errors.h"
#include "weld_profiler/ros/messages.h"

namespace weld_profiler
{
ScanBagWriter::ScanBagWriter(StagedOutput& output, const std::string& target, ScanBagNames names,
                             const CameraCalibration& camera)
  : target_(target), names_(std::move(names)), camera_(camera), bag_(std::make_unique<rosbag::Bag>())
{
  try
  {
    bag_->open(output.file(target), rosbag::bagmode::Write);
  }
  catch (const rosbag::BagException& error)
  {
    giveUp(error.what());
  }
}

ScanBagWriter::~ScanBagWriter()
{
  try
  {
    if (bag_)
      bag_->close();
  }
  catch (const rosbag::BagException&)
  {
    static_cast<void>(bag_.release());  // as in giveUp()
  }
}

// The destructor of a Bag ends the file, and throws when that fails, too: with a full disk that would end the process.
// So a bag that could not be written is left as it is until the process ends; its file is removed by StagedOutput.
void ScanBagWriter::giveUp(const std::string& cause)
{
  static_cast<void>(bag_.release());
  throw InputError(target_ + ": cannot be written (is the disk full?): " + cause);
}

template <class Message>
void ScanBagWriter::write(const std::string& topic, const Message& message, const Stamp& stamp)
{
  try
  {
    bag_->write(topic, toRosTime(stamp), message);
  }
  catch (const rosbag::BagException& error)
  {
    giveUp(error.what());
  }
}

void ScanBagWriter::writeEncoder(const EncoderSample& sample)
{
  const sensor_msgs::JointState message = jointStateMessage(sample.stamp, names_.joint, sample.position);
  write(names_.name_space + "/joint_states", message, sample.stamp);
}

void ScanBagWriter::writePose(const PoseSample& sample)
{
  geometry_msgs::TransformStamped transform;
  transform.header.stamp = toRosTime(sample.stamp);
  transform.header.frame_id = names_.fixed_frame;
  transform.child_frame_id = names_.camera_frame;
  transform.transform.translation.x = sample.x;
  transform.transform.translation.y = sample.y;
  transform.transform.translation.z = sample.z;
  transform.transform.rotation.x = sample.qx;
  transform.transform.rotation.y = sample.qy;
  transform.transform.rotation.z = sample.qz;
  transform.transform.rotation.w = sample.qw;
  tf2_msgs::TFMessage message;
  message.transforms.push_back(transform);
  write("/tf", message, sample.stamp);
}

void ScanBagWriter::writeSamplesUntil(Stamp stamp)
{
  constexpr Stamp kNever = std::numeric_limits<Stamp>::max();
  for (;;)
  {
    const Stamp encoder = next_encoder_ < encoder_.size() ? encoder_[next_encoder_].stamp : kNever;
    const Stamp pose = next_pose_ < poses_.size() ? poses_[next_pose_].stamp : kNever;
    if (std::min(encoder, pose) > stamp || std::min(encoder, pose) == kNever)
      return;
    if (encoder <= pose)
      writeEncoder(encoder_[next_encoder_++]);
    else
      writePose(poses_[next_pose_++]);
  }
}

void ScanBagWriter::writeFrame(Frame&& frame)
{
  const Stamp stamp = frame.stamp;
  writeSamplesUntil(stamp);
  const sensor_msgs::ImagePtr image = imageMessage(std::move(frame), names_.camera_frame);
  sensor_msgs::CameraInfo info = cameraInfoMessage(camera_);
  info.header = image->header;
  write(names_.name_space + "/camera_info", info, stamp);
  write(names_.name_space + "/image_raw", *image, stamp);
}

void ScanBagWriter::close()
{
  writeSamplesUntil(std::numeric_limits<Stamp>::max());
  try
  {
    bag_->close();
  }
  catch (const rosbag::BagException& error)
  {
    giveUp(error.what());
  }
}
}  // namespace weld_profiler
