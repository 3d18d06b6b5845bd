#include "weld_profiler/weld/grinding_params.h"

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "weld_profiler/core/errors.h"

using namespace weld_profiler;

namespace
{
const double kNan = std::numeric_limits<double>::quiet_NaN();

template <class Params>
void expectRefusal(const Params& params, const std::string& field)
{
  try
  {
    params.validate();
    ADD_FAILURE() << field << " was taken";
  }
  catch (const ConfigError& error)
  {
    EXPECT_EQ(std::string(error.what()).find(field + " is "), 0U) << error.what();
  }
}

template <class Params>
void expectRanges(const std::vector<std::pair<std::string, double Params::*>>& fields)
{
  EXPECT_NO_THROW(Params().validate());
  for (const auto& field : fields)
    for (const double value : { kNan, -1.0, 60.0 })
    {
      Params params;
      params.*field.second = value;
      expectRefusal(params, field.first);
    }
}
}  // namespace

TEST(WeldSurfaceParams, RefuseWhatIsOutOfRangeByName)
{
  expectRanges<WeldSurfaceParams>({
      { "mesh_step", &WeldSurfaceParams::mesh_step },
      { "target_margin", &WeldSurfaceParams::target_margin },
      { "max_gap", &WeldSurfaceParams::max_gap },
      { "edge_inset", &WeldSurfaceParams::edge_inset },
      { "min_angle_deg", &WeldSurfaceParams::min_angle_deg },
      { "min_piece_area", &WeldSurfaceParams::min_piece_area },
  });
}

TEST(GrindingParams, RefuseWhatIsOutOfRangeByName)
{
  expectRanges<GrindingParams>({
      { "tool_width", &GrindingParams::tool_width },
      { "overlap", &GrindingParams::overlap },
      { "depth_per_pass", &GrindingParams::depth_per_pass },
      { "point_spacing", &GrindingParams::point_spacing },
      { "margin", &GrindingParams::margin },
      { "min_removal", &GrindingParams::min_removal },
      { "bridge_length", &GrindingParams::bridge_length },
      { "approach_height", &GrindingParams::approach_height },
  });
  GrindingParams params;
  params.order = "spiral";
  expectRefusal(params, "order");
  params = GrindingParams();
  params.surface.mesh_step = kNan;
  expectRefusal(params, "mesh_step");
}
