#include "weld_profiler/weld/weld_params.h"

#include <array>
#include <sstream>

#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
void WeldParams::validate() const
{
  requireOneOf("kind", kind, std::array<std::string, 4>{ { "auto", "butt", "fillet", "bead_on_plate" } });
  requireOneOf("target", target, std::array<std::string, 2>{ { "flush", "rest" } });
  requireRange("rest_height", rest_height, 0.0, 0.01, "m");
  requireRange("section_step", section_step, 0.0, 0.1, "m");
  requireRange("min_width", min_width, 5e-4, 0.1, "m");
  requireRange("max_width", max_width, 1e-3, 0.2, "m");
  requireRange("min_height", min_height, 1e-6, 0.01, "m");
  requireRange("parent_length", parent_length, 1e-3, 0.1, "m");
  requireRange("min_parent_length", min_parent_length, 5e-4, 0.05, "m");
  requireRange("flatness", flatness, 1e-6, 1e-3, "m");
  requireRange("undercut_reach", undercut_reach, 2e-4, 0.01, "m");
  requireRange("face_length", face_length, 3e-4, 0.01, "m");
  requireRange("edge_blur", edge_blur, 0.0, 1e-3, "m");
  requireRange("max_gap", max_gap, 1e-4, 0.01, "m");
  requireRange("max_bridge", max_bridge, 0.0, 0.01, "m");
  requireRange("max_width_sigma", max_width_sigma, 1e-6, 0.01, "m");
  requireRange("same_plate_offset", same_plate_offset, 0.0, 1e-3, "m");
  requireRange("same_plate_angle_deg", same_plate_angle_deg, 0.0, 10.0, "deg");
  const auto requireLess = [](const char* low, double below, const char* high, double above)
  {
    if (below < above)
      return;
    std::ostringstream text;
    text << low << " is " << below << ", must be less than " << high << " (" << above << ") m";
    throw ConfigError(text.str());
  };
  requireLess("min_width", min_width, "max_width", max_width);
  requireLess("min_parent_length", min_parent_length, "parent_length", parent_length);
  requireLess("edge_blur", edge_blur, "face_length", face_length);
}
}  // namespace weld_profiler
