#pragma once

#include "weld_profiler/core/stripe.h"

namespace weld_profiler
{
/// What the repair of breakpoints needs to know. [px] of the image
struct RepairSettings
{
  int max_gap_px = 20;
  int edge_trim_px = 4;
  int pitch = 1;       ///< from one cell to the next
  int first_cell = 0;  ///< of the region looked at
  int last_cell = 0;
  bool interpolating = false;  ///< the paper's spline through every centre instead of the least-squares cubic
};

/// The paper's repair of breakpoints (section 2.5): fills breaks in the centre line, flags what it filled and gives it
/// a sigma that grows with the distance from what was measured.
///
/// Sound reading: one cubic, fitted by least squares to 15 centres either side. (A spline that passes through every
/// noisy centre swings: three times the error over a gap of 5 columns.) Left open: breaks longer than max_gap_px, a
/// step or an edge, and cells at the ends of the image, where nothing holds the curve.
void repairGaps(const RepairSettings& settings, Stripe& stripe, Stripe& memory);
}  // namespace weld_profiler
