#pragma once

#include <map>
#include <string>
#include <vector>

#include <nodelet/loader.h>
#include <ros/ros.h>

namespace weld_profiler
{
/// A nodelet manager inside the test's process, so that the test sees the very messages the nodelets exchange.
class InProcessManager
{
public:
  explicit InProcessManager(const std::string& name_space) : name_space_(name_space), spinner_(4) { spinner_.start(); }

  ~InProcessManager()
  {
    loader_.clear();
    spinner_.stop();
    ros::param::del(name_space_);
  }

  /// Sets a parameter of a nodelet before it is loaded.
  template <class T>
  void set(const std::string& nodelet, const std::string& name, const T& value)
  {
    ros::param::set(name_space_ + "/" + nodelet + "/" + name, value);
  }

  bool load(const std::string& nodelet)
  {
    return loader_.load(name_space_ + "/" + nodelet, "weld_profiler/" + nodelet, {}, {});
  }

  bool unload(const std::string& nodelet) { return loader_.unload(name_space_ + "/" + nodelet); }

  std::vector<std::string> loaded() { return loader_.listLoadedNodelets(); }

  std::string topic(const std::string& name) const { return name_space_ + "/" + name; }

private:
  std::string name_space_;
  ros::AsyncSpinner spinner_;
  nodelet::Loader loader_{ false };
};

/// Waits until the condition holds. @return whether it did.
template <class Condition>
bool waitFor(Condition condition, double seconds = 20.0)
{
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(seconds);
  while (!condition())
  {
    if (ros::WallTime::now() > end)
      return false;
    ros::WallDuration(0.005).sleep();
  }
  return true;
}
}  // namespace weld_profiler
