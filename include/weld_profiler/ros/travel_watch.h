#pragma once

#include <cmath>
#include <cstdint>
#include <mutex>

#include <ros/time.h>

#include "weld_profiler/core/profile.h"

namespace weld_profiler
{
/// How far the stage has come since a scan was asked for. Thread safe.
class TravelWatch
{
public:
  struct Travel
  {
    std::uint32_t profiles = 0;
    double first = 0.0, last = 0.0;  ///< stage positions [m]
    double age = 0.0;                ///< of the last profile when it came [s]
    ros::WallTime moved;             ///< when the stage last moved
  };

  void restart()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    travel_ = Travel{};
    placed_ = false;
    travel_.moved = ros::WallTime::now();
  }

  /// A profile without a point counts, but has no place.
  void add(const Profile& profile, double age)
  {
    constexpr double kMoved = 5e-6;  // less is the encoder's last digit [m]
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!profile.points.empty())
    {
      if (!placed_)
        travel_.first = travel_.last = profile.stage;
      placed_ = true;
      if (std::abs(profile.stage - travel_.last) > kMoved)
      {
        travel_.last = profile.stage;
        travel_.moved = ros::WallTime::now();
      }
    }
    ++travel_.profiles;
    travel_.age = age;
  }

  Travel travel() const
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    return travel_;
  }

private:
  mutable std::mutex mutex_;
  Travel travel_;
  bool placed_ = false;  ///< a profile with a place has come
};
}  // namespace weld_profiler
