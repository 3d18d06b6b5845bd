#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include <rosbag/bag.h>
#include <rosbag/view.h>

namespace weld_profiler
{
/// A copy of a bag with every message of one type through change, which may leave it out by returning false.
template <class Message>
void rewriteBag(const std::string& from, const std::string& to,
                const std::function<bool(std::size_t, Message&)>& change)
{
  rosbag::Bag source(from, rosbag::bagmode::Read);
  rosbag::Bag bag(to, rosbag::bagmode::Write);
  std::size_t index = 0;
  for (const rosbag::MessageInstance& message : rosbag::View(source))
  {
    const boost::shared_ptr<Message> changed = message.instantiate<Message>();
    if (!changed)
      bag.write(message.getTopic(), message.getTime(), message);
    else if (change(index++, *changed))
      bag.write(message.getTopic(), message.getTime(), *changed);
  }
}
}  // namespace weld_profiler
