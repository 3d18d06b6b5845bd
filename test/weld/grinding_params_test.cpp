#include "weld_profiler/weld/grinding_params.h"

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "weld_profiler/core/errors.h"

using namespace weld_profiler;

TEST(WeldSurfaceParams, RefuseWhatIsOutOfRangeByName)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::pair<std::string, double WeldSurfaceParams::*>> fields = {
    { "mesh_step", &WeldSurfaceParams::mesh_step },
    { "target_margin", &WeldSurfaceParams::target_margin },
    { "max_gap", &WeldSurfaceParams::max_gap },
    { "edge_inset", &WeldSurfaceParams::edge_inset },
    { "min_angle_deg", &WeldSurfaceParams::min_angle_deg },
    { "min_piece_area", &WeldSurfaceParams::min_piece_area },
  };
  EXPECT_NO_THROW(WeldSurfaceParams().validate());
  for (const auto& field : fields)
    for (const double value : { nan, -1.0, 60.0 })
    {
      WeldSurfaceParams params;
      params.*field.second = value;
      try
      {
        params.validate();
        ADD_FAILURE() << field.first << " " << value << " was taken";
      }
      catch (const ConfigError& error)
      {
        EXPECT_EQ(std::string(error.what()).find(field.first + " is "), 0U) << error.what();
      }
    }
}

TEST(GrindingParams, RefuseWhatIsOutOfRangeByName)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::pair<std::string, double GrindingParams::*>> fields = {
    { "tool_width", &GrindingParams::tool_width },
    { "overlap", &GrindingParams::overlap },
    { "depth_per_pass", &GrindingParams::depth_per_pass },
    { "point_spacing", &GrindingParams::point_spacing },
    { "margin", &GrindingParams::margin },
    { "min_removal", &GrindingParams::min_removal },
    { "bridge_length", &GrindingParams::bridge_length },
    { "approach_height", &GrindingParams::approach_height },
  };
  const auto expectRefusal = [](const GrindingParams& params, const std::string& field)
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
  };
  EXPECT_NO_THROW(GrindingParams().validate());
  for (const auto& field : fields)
    for (const double value : { nan, -1.0, 60.0 })
    {
      GrindingParams params;
      params.*field.second = value;
      expectRefusal(params, field.first);
    }
  GrindingParams params;
  params.order = "spiral";
  expectRefusal(params, "order");
  params = GrindingParams();
  params.surface.mesh_step = nan;
  expectRefusal(params, "mesh_step");
}
