#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include <boost/make_shared.hpp>
#include <boost/shared_ptr.hpp>

namespace weld_profiler
{
/// Hands out messages and takes each back when its last reader lets go, never before, so that image- and cloud-sized
/// memory is allocated once. Thread safe; messages may outlive the pool.
template <class Message>
class MessagePool
{
public:
  /// @param most_idle  messages kept for reuse; what comes back beyond is freed.
  explicit MessagePool(std::size_t most_idle = 16) : store_(std::make_shared<Store>())
  {
    store_->most_idle = most_idle;
  }

  /// A message of unspecified content (that of its last use), owned by nobody else.
  boost::shared_ptr<Message> take()
  {
    std::unique_ptr<Message> message;
    {
      const std::lock_guard<std::mutex> lock(store_->mutex);
      if (!store_->idle.empty())
      {
        message = std::move(store_->idle.back());
        store_->idle.pop_back();
      }
    }
    if (!message)
      message = std::make_unique<Message>();
    const std::shared_ptr<Store> store = store_;
    return boost::shared_ptr<Message>(message.release(), [store](Message* returned) { store->giveBack(returned); });
  }

private:
  struct Store
  {
    void giveBack(Message* returned)
    {
      std::unique_ptr<Message> message(returned);
      const std::lock_guard<std::mutex> lock(mutex);
      if (idle.size() < most_idle)
        idle.push_back(std::move(message));
    }

    std::mutex mutex;
    std::vector<std::unique_ptr<Message>> idle;
    std::size_t most_idle = 16;
  };

  std::shared_ptr<Store> store_;
};
}  // namespace weld_profiler
