#include "tools/bag_scan.h"

#include <filesystem>
#include <optional>
#include <set>

#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <tf2_msgs/TFMessage.h>

#include "tools/bag_topics.h"
#include "tools/progress.h"
#include "weld_profiler/core/errors.h"
#include "weld_profiler/ros/messages.h"
#include "weld_profiler/stripe/stripe_stage.h"

namespace weld_profiler
{
namespace
{
constexpr double kTransformCache = 1e7;  // [s]: of a bag nothing is forgotten

/// The bag's messages through the chain, one after the other.
class BagReader
{
public:
  BagReader(const BagScanParams& params, const BagTopics& topics)
    : params_(params),
      topics_(topics),
      transforms_(ros::Duration(kTransformCache)),
      stage_(params.stripe),
      chain_(params.chain, params.calibration, transforms_, sinks())
  {
  }

  void take(const rosbag::MessageInstance& message)
  {
    const std::string& topic = message.getTopic();
    if (topic == topics_.image)
      takeImage(*instantiate<sensor_msgs::Image>(message));
    else if (topic == topics_.info)
      takeInfo(*instantiate<sensor_msgs::CameraInfo>(message));
    else if (topic == topics_.joints)
      takeJoints(*instantiate<sensor_msgs::JointState>(message));
    else
      takeTransforms(*instantiate<tf2_msgs::TFMessage>(message), topic == "/tf_static");
  }

  BagScanResult finish()
  {
    chain_.builder().finish();
    result_.name_space = topics_.name_space;
    result_.balance = chain_.builder().balance();
    if (result_.balance.rows == 0 && params_.chain.motion == "stage" && !joint_found_)
      throw InputError(params_.bag + ": joint '" + params_.calibration.stage.joint + "' is not in " + topics_.joints +
                       " (there are: " + listOf(joints_) + "), set stage/joint in the calibration file");
    return std::move(result_);
  }

  void takeInfo(const sensor_msgs::CameraInfo& info) { chain_.addCameraInfo(info); }

  /// Why frames were refused, the first time each; empty = nothing to say.
  std::string takeProblem()
  {
    std::string problem = chain_.takeProblem();
    if (problem.empty())
      problem.swap(problem_);
    problem_.clear();
    return problem;
  }

private:
  template <class Message>
  boost::shared_ptr<Message> instantiate(const rosbag::MessageInstance& message) const
  {
    boost::shared_ptr<Message> result = message.instantiate<Message>();
    if (!result)
      throw InputError(params_.bag + ": topic " + message.getTopic() + " is a " + message.getDataType() +
                       ", must be a " + ros::message_traits::DataType<Message>::value());
    return result;
  }

  ScanBuilder::Sinks sinks()
  {
    ScanBuilder::Sinks sinks;
    sinks.on_scan = [this](Scan&& scan) { result_.scans.push_back(std::move(scan)); };
    return sinks;
  }

  void takeImage(const sensor_msgs::Image& image)
  {
    if (last_seq_ && image.header.seq > *last_seq_ + 1)
      result_.frame_gaps += image.header.seq - *last_seq_ - 1;
    last_seq_ = image.header.seq;
    StripeProfile profile;
    profile.header = image.header;
    profile.frame = image.header.seq;
    profile.image_width = image.width;
    profile.image_height = image.height;
    try
    {
      stage_.process(rawImage(image), workspace_, stripe_);
    }
    catch (const std::exception& error)
    {
      chain_.builder().countDropped("bad_image");
      problem_ = error.what();
      return;
    }
    swapStripe(stripe_, profile);
    chain_.addStripe(profile);
  }

  void takeJoints(const sensor_msgs::JointState& joints)
  {
    joint_found_ = chain_.addJoints(joints) || joint_found_;
    if (!joint_found_)
      joints_.insert(joints.name.begin(), joints.name.end());
  }

  void takeTransforms(const tf2_msgs::TFMessage& message, bool is_static)
  {
    for (const geometry_msgs::TransformStamped& transform : message.transforms)
      transforms_.setTransform(transform, params_.bag, is_static);
    chain_.poll();
  }

  const BagScanParams& params_;
  const BagTopics& topics_;
  BagScanResult result_;
  tf2::BufferCore transforms_;
  StripeStage stage_;
  ScanChain chain_;
  Workspace workspace_;
  Stripe stripe_;
  std::optional<std::uint32_t> last_seq_;
  bool joint_found_ = false;
  std::string problem_;
  std::set<std::string> joints_;
};

void open(rosbag::Bag& bag, const std::string& path)
{
  if (!std::filesystem::exists(path))
    throw InputError(path + ": no such bag, check the path");
  try
  {
    bag.open(path, rosbag::bagmode::Read);
  }
  catch (const rosbag::BagException& error)
  {
    throw InputError(path + ": no bag, or one that is truncated or was not closed (" + error.what() +
                     "): run `rosbag reindex` on it");
  }
}

/// The first message of a topic, null when there is none.
boost::shared_ptr<sensor_msgs::CameraInfo> firstInfo(const rosbag::Bag& bag, const std::string& topic)
{
  for (const rosbag::MessageInstance& message : rosbag::View(bag, rosbag::TopicQuery(topic)))
    return message.instantiate<sensor_msgs::CameraInfo>();
  return nullptr;
}
}  // namespace

BagScanResult scanBag(const BagScanParams& params)
{
  rosbag::Bag bag;
  open(bag, params.bag);
  const BagTopics topics = chooseTopics(bag, params);
  BagReader reader(params, topics);
  try
  {
    // an image may lie before its camera_info in the bag
    if (const auto info = firstInfo(bag, topics.info))
      reader.takeInfo(*info);
    rosbag::View view(bag, rosbag::TopicQuery(topics.all()));
    Progress progress("scanning", view.size());
    std::set<std::string> said;
    for (const rosbag::MessageInstance& message : view)
    {
      reader.take(message);
      const std::string problem = reader.takeProblem();
      if (!problem.empty() && said.insert(problem).second)
        progress.say("scan_bag: " + params.bag + ": " + problem + "; the frame is dropped");
      progress.step();
    }
  }
  catch (const rosbag::BagException& error)
  {
    throw InputError(params.bag + ": the bag is damaged (" + error.what() + "), run `rosbag reindex` on it");
  }
  return reader.finish();
}
}  // namespace weld_profiler
