#include <cmath>

#include <gtest/gtest.h>

#include "weld_profiler/core/errors.h"
#include "weld_profiler/simulation/scene_params.h"

namespace weld_profiler
{
namespace
{
struct Refused
{
  std::string what;
  void (*change)(SceneParams&);
};

void expectRefused(const std::vector<Refused>& refusals)
{
  for (const Refused& refused : refusals)
  {
    SceneParams scene;
    refused.change(scene);
    try
    {
      scene.validate();
      ADD_FAILURE() << refused.what << " was accepted";
    }
    catch (const ConfigError& error)
    {
      EXPECT_EQ(std::string(error.what()).find(refused.what), 0U) << error.what() << " instead of " << refused.what;
    }
  }
}

TEST(ScenePart, RefusesDimensionsThatItsKindOfWeldHasNot)
{
  expectRefused({
      { "weld.kind is 'corner'", [](SceneParams& s) { s.weld.kind = "corner"; } },
      { "plates.misalignment is 0.001, must be in [0, 0] m (weld.kind is bead_on_plate)",
        [](SceneParams& s) { s.weld.kind = "bead_on_plate", s.plates.misalignment = 0.001; } },
      { "plates.angle_deg is 2, must be in [0, 0] deg (weld.kind is bead_on_plate)",
        [](SceneParams& s) { s.weld.kind = "bead_on_plate", s.plates.angle_deg = 2.0; } },
      { "weld.reinforcement is -0.001, must be in [0",
        [](SceneParams& s) { s.weld.kind = "bead_on_plate", s.weld.reinforcement = -0.001; } },
      { "plates.angle_deg is 0, must be in [30, 120]", [](SceneParams& s) { s.weld.kind = "fillet"; } },
      { "plates.misalignment is 0.001, must be in [0, 0] m (weld.kind is fillet)",
        [](SceneParams& s) { s.weld.kind = "fillet", s.plates.angle_deg = 90.0, s.plates.misalignment = 0.001; } },
      { "weld.reinforcement is -0.004",
        [](SceneParams& s) { s.weld.kind = "fillet", s.plates.angle_deg = 90.0, s.weld.reinforcement = -0.004; } },
      { "weld.reinforcement is 0.001",
        [](SceneParams& s) {
          s.weld.kind = "fillet", s.plates.angle_deg = 90.0, s.weld.reinforcement = 0.001, s.weld.crater_end = 0.003;
        } },
      { "weld.reinforcement is -0.006", [](SceneParams& s) { s.weld.reinforcement = -0.006; } },
  });
}

TEST(ScenePart, RefusesWhatItCannotBe)
{
  expectRefused({
      { "weld.crest_offset is 0.4", [](SceneParams& s) { s.weld.crest_offset = 0.4; } },
      { "weld.tack_length is -1", [](SceneParams& s) { s.weld.tack_length = -1.0; } },
      { "weld.tack_gap is 0,", [](SceneParams& s) { s.weld.tack_gap = 0.0; } },
      { "weld.end_length is 0.004, must be in [0, 0.0025]", [](SceneParams& s) { s.weld.tack_length = 0.005; } },
      { "weld.crater_start is -0.001", [](SceneParams& s) { s.weld.crater_start = -0.001; } },
      { "weld.crater_end is nan", [](SceneParams& s) { s.weld.crater_end = std::nan(""); } },
      { "weld.crater_length is 0,", [](SceneParams& s) { s.weld.crater_length = 0.0; } },
      { "second_bead.offset is 0.1", [](SceneParams& s) { s.second_bead.offset = 0.1; } },
      { "second_bead.offset is 0.008",
        [](SceneParams& s) { s.second_bead.width = 0.006, s.second_bead.offset = 0.008; } },
      { "second_bead.width is -1", [](SceneParams& s) { s.second_bead.width = -1.0; } },
      { "second_bead.reinforcement is 0.004",
        [](SceneParams& s) { s.second_bead.width = 0.006, s.second_bead.reinforcement = 0.004; } },
      { "plates.angle_deg is 121", [](SceneParams& s) { s.plates.angle_deg = 121.0; } },
      { "plates.tilt_deg is 41", [](SceneParams& s) { s.plates.tilt_deg = 41.0; } },
      { "plates.angle_deg is 100", [](SceneParams& s) { s.plates.angle_deg = 100.0, s.plates.tilt_deg = -20.0; } },
      { "pores.count is -1", [](SceneParams& s) { s.pores.count = -1; } },
      { "pores.diameter_min is 0,", [](SceneParams& s) { s.pores.diameter_min = 0.0; } },
      { "pores.diameter_max is 0.0001", [](SceneParams& s) { s.pores.diameter_max = 0.0001; } },
      { "pores.depth is 0.6", [](SceneParams& s) { s.pores.depth = 0.6; } },
  });
}

TEST(ScenePart, AcceptsEachKindOfWeld)
{
  SceneParams scene;
  EXPECT_NO_THROW(scene.validate());
  scene.weld.kind = "bead_on_plate";
  EXPECT_NO_THROW(scene.validate());
  scene.weld.kind = "fillet";
  scene.plates.angle_deg = 90.0;
  scene.weld.reinforcement = -0.001;
  EXPECT_NO_THROW(scene.validate());
}
}  // namespace
}  // namespace weld_profiler
