#pragma once

#include <vector>

#include "column_track.h"

namespace weld_profiler
{
/// How fast the stripe's width across itself changes along it, stretch by stretch.
class WidthGrowth
{
public:
  /// @param held   columns held of nine around a slot.
  /// @param slope  of the line, rows a column.
  void learn(const ColumnTrack& track, const float* held, const float* slope);

  /// One a stretch of ControlVariates::kStretch slots, in widths a column: as much as the stretches beside agree upon.
  const std::vector<float>& perColumn() const { return growth_; }

private:
  std::vector<float> rise_, growth_;
};
}  // namespace weld_profiler
