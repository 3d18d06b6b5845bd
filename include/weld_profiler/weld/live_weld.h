#pragma once

#include "weld_profiler/weld/live_yaw.h"
#include "weld_profiler/weld/weld_measurer.h"

namespace weld_profiler
{
/// Provisional sections while a scan runs. The weld's yaw is told from the rows of this scan that came before, and its
/// uncertainty is in what is told of a row.
class LiveWeld
{
public:
  explicit LiveWeld(const WeldMeasurer& measurer) : measurer_(measurer) {}

  /// @see WeldMeasurer::measureRow
  WeldSection measure(const Profile& profile);

  /// Another scan begins: nothing is known of its yaw.
  void restart() { yaw_.restart(); }

private:
  WeldMeasurer measurer_;
  LiveYaw yaw_;
};
}  // namespace weld_profiler
