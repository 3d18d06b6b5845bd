#pragma once

#include <string>

#include "weld_profiler/weld/weld_surface.h"

namespace weld_profiler
{
/// How a weld is to be ground. SI.
struct GrindingParams
{
  double tool_width = 6e-3;       ///< of the tool's contact, across the travel [m], 0.0005..0.2
  double overlap = 0.3;           ///< of neighbouring passes, a share of the tool's width, 0..0.9
  double depth_per_pass = 3e-4;   ///< largest depth that one pass removes [m], 0.00001..0.01
  double point_spacing = 1e-3;    ///< of the poses along the weld [m], surface.mesh_step..0.1
  double margin = 1e-3;           ///< the last layer covers this much beyond each toe [m], 0..tool_width / 2
  double min_removal = 2e-5;      ///< less than this is no reason for a pass [m], 0..depth_per_pass
  double bridge_length = 3e-3;    ///< shorter stretches with nothing to remove do not end a pass [m], 0..0.1
  double approach_height = 0.02;  ///< of approach and retract along the normal [m], 0..0.5
  std::string order = "one_way";  ///< one_way: every pass along the weld; alternate: every other one back
  WeldSurfaceParams surface;

  /// @throws ConfigError naming field, value and range.
  void validate() const;

  template <class Visitor>
  void visit(Visitor&& v)
  {
    v("tool_width", tool_width);
    v("overlap", overlap);
    v("depth_per_pass", depth_per_pass);
    v("point_spacing", point_spacing);
    v("margin", margin);
    v("min_removal", min_removal);
    v("bridge_length", bridge_length);
    v("approach_height", approach_height);
    v("order", order);
    surface.visit(v);
  }
};
}  // namespace weld_profiler
