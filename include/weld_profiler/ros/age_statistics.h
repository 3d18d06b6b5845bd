#pragma once

#include <cstddef>
#include <mutex>
#include <vector>

namespace weld_profiler
{
/// Ages (now - stamp) of the last messages, and their rate. Thread safe.
class AgeStatistics
{
public:
  explicit AgeStatistics(std::size_t window = 1024);

  /// @param age  [s]; @param now  [s], for the rate.
  void add(double age, double now);

  struct Summary
  {
    std::size_t count = 0;  ///< ages the figures rest on
    double p50 = 0.0;       ///< [s]
    double p99 = 0.0;       ///< [s]
    double max = 0.0;       ///< [s]
    double rate = 0.0;      ///< [1/s]; 0 with fewer than two
  };
  Summary summary() const;

private:
  mutable std::mutex mutex_;
  std::size_t window_;
  std::size_t next_ = 0;
  double latest_ = 0.0;
  std::vector<double> ages_;
  std::vector<double> times_;
};
}  // namespace weld_profiler
