#include "tools/bag_topics.h"

#include <rosbag/view.h>

#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
namespace
{
const std::string kImageTopic = "image_raw";

std::set<std::string> topicsOf(const rosbag::Bag& bag)
{
  std::set<std::string> topics;
  rosbag::View view(bag);
  for (const rosbag::ConnectionInfo* connection : view.getConnections())
    topics.insert(connection->topic);
  return topics;
}

/// The namespace whose image_raw is scanned, with its slashes: "/profiler/".
std::string chooseNamespace(const BagScanParams& params, const std::set<std::string>& topics)
{
  std::set<std::string> found;
  for (const std::string& topic : topics)
  {
    const std::size_t at = topic.rfind('/') + 1;
    if (topic.substr(at) == kImageTopic)
      found.insert(topic.substr(0, at));
  }
  if (params.name_space.empty())
  {
    if (found.empty())
      throw InputError(params.bag + ": has no topic image_raw (it holds " + listOf(topics) +
                       "), record the profiler's");
    if (found.size() > 1)
      throw InputError(params.bag + ": image_raw is there in " + listOf(found) + ", choose one with --namespace");
    return *found.begin();
  }
  std::string wanted = params.name_space.front() == '/' ? params.name_space : "/" + params.name_space;
  if (wanted.back() != '/')
    wanted += '/';
  if (found.count(wanted) == 0)
    throw InputError(params.bag + ": has no topic " + wanted + kImageTopic + ", --namespace can be " + listOf(found));
  return wanted;
}

/// The camera's own joint_states, or the robot's.
std::string chooseJointTopic(const BagScanParams& params, const std::set<std::string>& topics,
                             const std::string& name_space)
{
  for (const std::string& topic : { name_space + "joint_states", std::string("/joint_states") })
  {
    if (topics.count(topic) != 0)
      return topic;
  }
  if (params.chain.motion == "stage")
    throw InputError(params.bag + ": has no topic " + name_space + "joint_states (it holds " + listOf(topics) +
                     "), record the encoder, or use motion: tf");
  return name_space + "joint_states";
}
}  // namespace

BagTopics chooseTopics(const rosbag::Bag& bag, const BagScanParams& params)
{
  const std::set<std::string> topics = topicsOf(bag);
  const std::string name_space = chooseNamespace(params, topics);
  return { name_space, name_space + kImageTopic, name_space + "camera_info",
           chooseJointTopic(params, topics, name_space) };
}

std::string listOf(const std::set<std::string>& names)
{
  std::string list;
  for (const std::string& name : names)
    list += (list.empty() ? "" : ", ") + name;
  return list.empty() ? "nothing" : list;
}
}  // namespace weld_profiler
