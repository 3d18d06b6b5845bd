#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace weld_profiler
{
/// Where every frame went: frames_in = rows + no_stripe + skipped + sum(unplaced) + sum(dropped) + those still waiting.
struct FrameBalance
{
  std::uint64_t frames_in = 0;
  std::uint64_t rows = 0;                         ///< rows of the cloud that hold a stripe
  std::uint64_t no_stripe = 0;                    ///< placed rows of NaN: the frame showed no stripe
  std::uint64_t skipped = 0;                      ///< left out by the trigger: the stage had not moved far enough
  std::map<std::string, std::uint64_t> unplaced;  ///< by reason: encoder_gap, before_first_sample, ...
  std::map<std::string, std::uint64_t> dropped;   ///< by reason: queue_full, camera_info, lost_by_driver, ...

  std::uint64_t unplacedTotal() const { return total(unplaced); }
  std::uint64_t droppedTotal() const { return total(dropped); }
  std::uint64_t accounted() const { return rows + no_stripe + skipped + unplacedTotal() + droppedTotal(); }

private:
  static std::uint64_t total(const std::map<std::string, std::uint64_t>& reasons)
  {
    std::uint64_t sum = 0;
    for (const auto& reason : reasons)
      sum += reason.second;
    return sum;
  }
};
}  // namespace weld_profiler
