#include "weld_profiler/ros/age_statistics.h"

#include <algorithm>

namespace weld_profiler
{
AgeStatistics::AgeStatistics(std::size_t window) : window_(window)
{
  ages_.reserve(window);
  times_.reserve(window);
}

void AgeStatistics::add(double age, double now)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  if (now < latest_)  // a looping bag: begin again
  {
    ages_.clear();
    times_.clear();
    next_ = 0;
  }
  latest_ = now;
  if (ages_.size() < window_)
  {
    ages_.push_back(age);
    times_.push_back(now);
    return;
  }
  ages_[next_] = age;
  times_[next_] = now;
  next_ = (next_ + 1) % window_;
}

AgeStatistics::Summary AgeStatistics::summary() const
{
  Summary result;
  std::vector<double> sorted;
  double first = 0.0;
  double last = 0.0;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (ages_.empty())
      return result;
    sorted = ages_;
    first = *std::min_element(times_.begin(), times_.end());
    last = *std::max_element(times_.begin(), times_.end());
  }
  std::sort(sorted.begin(), sorted.end());
  result.count = sorted.size();
  const auto rank = [&sorted](double share)
  { return sorted[std::min(sorted.size() - 1, static_cast<std::size_t>(share * static_cast<double>(sorted.size())))]; };
  result.p50 = rank(0.50);
  result.p99 = rank(0.99);
  result.max = sorted.back();
  if (last > first)
    result.rate = static_cast<double>(sorted.size() - 1) / (last - first);
  return result;
}
}  // namespace weld_profiler
