#pragma once

#include "group_path.h"

namespace weld_profiler
{
/// The stripe in one group of columns: where it lies to a pixel or so, how wide it is and on what background.
struct GroupProfile
{
  static constexpr float kNarrowest = 0.6F;  ///< half width that is told [px]

  float u = 0.0F, v = 0.0F, sigma = 0.0F;    ///< [px]
  float background = 0.0F, gradient = 0.0F;  ///< [grey levels], per row
  float ambiguous = 0.0F;                    ///< 1 where a second peak was nearly as good
  float span = 0.0F;                         ///< between the flanks that tell the background [px]
  bool starts_piece = false;
};

/// From the sums around a node: centre and half width from what is above half of the height, background from the
/// medians of three samples in both flanks, as far as no other top stands there.
GroupProfile measureGroup(const GroupSums& sums, const PathNode& node);
}  // namespace weld_profiler
