#pragma once

#include <mutex>
#include <string>
#include <vector>

#include <ros/ros.h>
#include <boost/function.hpp>

namespace weld_profiler
{
/// Subscribes and keeps every message alive, so that no address can come twice. Thread safe.
template <class Message>
class Collector
{
public:
  using Ptr = boost::shared_ptr<const Message>;

  explicit Collector(const std::string& topic)
  {
    const boost::function<void(const Ptr&)> keep = [this](const Ptr& message)
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      messages_.push_back(message);
    };
    subscriber_ = node_.subscribe<Message>(topic, 0, keep);
  }

  ~Collector() { subscriber_.shutdown(); }

  std::vector<Ptr> all() const
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    return messages_;
  }

  std::size_t size() const { return all().size(); }
  std::uint32_t publishers() const { return subscriber_.getNumPublishers(); }

private:
  mutable std::mutex mutex_;
  std::vector<Ptr> messages_;
  ros::NodeHandle node_;
  ros::Subscriber subscriber_;
};
}  // namespace weld_profiler
