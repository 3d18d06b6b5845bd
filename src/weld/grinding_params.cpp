#include "weld_profiler/weld/grinding_params.h"

#include <array>

#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
void GrindingParams::validate() const
{
  surface.validate();
  requireRange("tool_width", tool_width, 5e-4, 0.2, "m");
  requireRange("overlap", overlap, 0.0, 0.9);
  requireRange("depth_per_pass", depth_per_pass, 1e-5, 0.01, "m");
  requireRange("point_spacing", point_spacing, surface.mesh_step, 0.1, "m");
  requireRange("margin", margin, 0.0, 0.5 * tool_width, "m");
  requireRange("min_removal", min_removal, 0.0, depth_per_pass, "m");
  requireRange("bridge_length", bridge_length, 0.0, 0.1, "m");
  requireRange("approach_height", approach_height, 0.0, 0.5, "m");
  requireOneOf("order", order, std::array<std::string, 2>{ { "one_way", "alternate" } });
}
}  // namespace weld_profiler
