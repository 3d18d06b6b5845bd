#include "weld_profiler/weld/compare_params.h"

#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
void CompareParams::validate() const
{
  requireRange("over_ground_limit", over_ground_limit, 1e-6, 0.01, "m");
  requireRange("min_spot_area", min_spot_area, 0.0, 1e-4, "m^2");
  requireRange("placement", placement, 1e-6, 0.01, "m");
  requireRange("placement_turn_deg", placement_turn_deg, 1e-3, 10.0, "deg");
  requireRange("max_residual", max_residual, 1e-6, 1e-3, "m");
  requireRange("max_shift", max_shift, 1e-3, 0.1, "m");
  requireRange("max_turn_deg", max_turn_deg, 0.1, 20.0, "deg");
}
}  // namespace weld_profiler
