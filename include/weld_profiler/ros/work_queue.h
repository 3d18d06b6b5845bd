#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <mutex>
#include <utility>

namespace weld_profiler
{
/// The bounded queue between a callback and the thread that works. Live, a full queue loses its oldest item and says
/// so; lossless, push waits for room. close() wakes everybody.
template <class Item>
class WorkQueue
{
public:
  WorkQueue(std::size_t capacity, bool lossless) : capacity_(capacity), lossless_(lossless) {}

  /// @return items lost to make room: 0 or 1 (and 1 for an item that comes after close()).
  std::size_t push(Item item)
  {
    std::unique_lock<std::mutex> lock(mutex_);
    if (lossless_)
      room_.wait(lock, [this] { return closed_ || items_.size() < capacity_; });
    if (closed_)
      return 1;
    std::size_t lost = 0;
    if (items_.size() >= capacity_)
    {
      items_.pop_front();
      lost = 1;
    }
    items_.push_back(std::move(item));
    filled_.notify_one();
    return lost;
  }

  /// Waits for an item. @return false once the queue is closed.
  bool pop(Item& item)
  {
    std::unique_lock<std::mutex> lock(mutex_);
    filled_.wait(lock, [this] { return closed_ || !items_.empty(); });
    if (closed_)
      return false;
    item = std::move(items_.front());
    items_.pop_front();
    room_.notify_one();
    return true;
  }

  void close()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    closed_ = true;
    filled_.notify_all();
    room_.notify_all();
  }

  std::size_t size() const
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    return items_.size();
  }

private:
  mutable std::mutex mutex_;
  std::condition_variable filled_;
  std::condition_variable room_;
  std::deque<Item> items_;
  const std::size_t capacity_;
  const bool lossless_;
  bool closed_ = false;
};
}  // namespace weld_profiler
