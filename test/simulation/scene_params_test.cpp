#include "weld_profiler/simulation/scene_params.h"

#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <limits>

#include <gtest/gtest.h>

#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
namespace
{
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

struct Refusal
{
  std::string field;
  std::function<void(SceneParams&)> change;
};

Refusal number(const std::string& field, double& (*pick)(SceneParams&), double value)
{
  return Refusal{ field, [pick, value](SceneParams& scene) { pick(scene) = value; } };
}

#define FIELD(name, value) \
  number(                  \
      #name, [](SceneParams& scene) -> double& { return scene.name; }, value)
#define CHANGE(field, ...)                         \
  Refusal                                          \
  {                                                \
    field, [](SceneParams& scene) { __VA_ARGS__; } \
  }

std::vector<Refusal> refusals()
{
  return
  {
    FIELD(start_time, -1.0), FIELD(frame_rate, 0.0), FIELD(scan_length, 0.0), FIELD(exposure, 0.06),
        FIELD(start_position, 11.0), FIELD(part_start, 3.0), FIELD(speed, 0.0), FIELD(speed, 2.0),
        FIELD(speed_variation, 1.0), FIELD(speed_period, 0.0), FIELD(tf_rotation_deg, 31.0), FIELD(pose_rate, 0.0),
        FIELD(encoder_rate, 0.0), FIELD(encoder_resolution, -1e-6), FIELD(rig_roll_deg, 181.0), FIELD(plates.x, 0.2),
        FIELD(plates.height, 0.1), FIELD(plates.misalignment, 0.02), FIELD(plates.angle_deg, 121.0),
        FIELD(weld.width, -0.001), FIELD(weld.reinforcement, 0.006), FIELD(weld.start, 3.0), FIELD(weld.length, 0.0),
        FIELD(weld.end_length, 0.03), FIELD(weld.yaw_deg, 31.0), FIELD(weld.curvature, 11.0),
        FIELD(weld.ripple_height, 0.003), FIELD(weld.ripple_pitch, 0.0), FIELD(weld.undercut_left, -0.001),
        FIELD(weld.undercut_right, 0.006), FIELD(weld.undercut_width, 0.0), FIELD(gauge.height, -0.001),
        FIELD(gauge.x, 0.3), FIELD(gauge.y, 3.0), FIELD(gauge.width, 0.0), FIELD(marker.length, 0.0),
        FIELD(spatter.radius_min, 0.0), FIELD(spatter.radius_max, 0.0001), FIELD(laser.sigma_px, 1.2),
        FIELD(laser.lens_sigma_px, 0.1), FIELD(laser.peak, 0.0), FIELD(laser.standoff, 0.0), FIELD(laser.shading, 1.1),
        FIELD(laser.specular, -1.0), FIELD(laser.specular_width_deg, 0.0), FIELD(laser.bead_reflectance, -0.1),
        FIELD(laser.interreflection, -0.1), FIELD(laser.ghost, 1.1), FIELD(laser.ghost_offset_px, 300.0),
        FIELD(laser.glow, 1.1), FIELD(laser.glow_sigma_px, 1.0), FIELD(speckle.contrast, 1.1),
        FIELD(speckle.grain_px, 0.5), FIELD(sensor.snr, 0.5), FIELD(sensor.snr, 200.0), FIELD(sensor.read_noise, 51.0),
        FIELD(sensor.black_level, -1.0), FIELD(light.ambient, -1.0), FIELD(light.ambient_transmission, 1.1),
        FIELD(light.arc, -1.0), FIELD(light.arc_transmission, -0.1), FIELD(light.flash_share, 1.1),
        FIELD(light.flash, -1.0), FIELD(start_time, kNan), FIELD(frame_rate, kNan), FIELD(scan_length, kNan),
        FIELD(exposure, kNan), FIELD(start_position, kNan), FIELD(part_start, kNan), FIELD(speed, kNan),
        FIELD(speed_variation, kNan), FIELD(speed_period, kNan), FIELD(encoder_rate, kNan), FIELD(weld.width, kNan),
        FIELD(weld.reinforcement, kNan), FIELD(laser.peak, kNan), FIELD(laser.sigma_px, kNan),
        FIELD(speckle.contrast, kNan), FIELD(sensor.snr, kNan), FIELD(sensor.read_noise, kNan),
        FIELD(light.ambient, kNan), CHANGE("frame_count", scene.frame_count = -1),
        CHANGE("speed", scene.speed = 2e-5; scene.scan_length = 2.0), CHANGE("motion", scene.motion = "robot"),
        CHANGE("tf_axis", scene.tf_axis = { { 0.0, 0.0, 0.0 } }), CHANGE("spatter.count", scene.spatter.count = -1),
        CHANGE("light.sparks", scene.light.sparks = -1), CHANGE("sensor.encoding", scene.sensor.encoding = "rgb8"),
        CHANGE("camera.image_width", scene.calibration.camera.image_width = 0),
        CHANGE("camera.image_height", scene.calibration.camera.image_height = 0),
        CHANGE("camera.fx", scene.calibration.camera.fx = 0.0), CHANGE("camera.fy", scene.calibration.camera.fy = kNan),
        CHANGE("camera.cx", scene.calibration.camera.cx = kNan),
        CHANGE("camera.cy", scene.calibration.camera.cy = kNan),
        CHANGE("camera.distortion_coefficients", scene.calibration.camera.distortion[1] = kNan),
        CHANGE("camera.roi x_offset", scene.calibration.camera.roi_x = -1),
        CHANGE("camera.roi y_offset", scene.calibration.camera.roi_y = 2000),
        CHANGE("camera.roi width", scene.calibration.camera.roi_width = 1441),
        CHANGE("camera.roi height", scene.calibration.camera.roi_height = 1081),
        CHANGE("camera.roi width", scene.calibration.camera.roi_width = 100),
        CHANGE("camera.binning_x", scene.calibration.camera.binning_x = 2),
        CHANGE("camera.binning_y", scene.calibration.camera.binning_y = 0),
        CHANGE("laser_plane.normal", scene.calibration.laser_plane.normal = { { 0.0, 0.0, 0.0 } }),
        CHANGE("laser_plane.distance", scene.calibration.laser_plane.distance = -0.1),
        CHANGE("stage.axis", scene.calibration.stage.axis = { { 0.0, -0.5, 0.5 } }),
        CHANGE("stage.axis", scene.calibration.stage.axis = { { 1.0, 0.0, 0.0 } }),
        CHANGE("stage.axis", scene.calibration.stage.axis = { { 0.0, 0.0, 1.0 } }),
        CHANGE("stage.type", scene.calibration.stage.type = "rotary"),
        CHANGE("stage.metres_per_unit", scene.calibration.stage.metres_per_unit = 0.0),
  };
}

TEST(SceneParams, RefusesEachFieldOutOfItsRangeByName)
{
  ASSERT_GT(refusals().size(), 90U);
  for (const Refusal& refusal : refusals())
  {
    SceneParams scene;
    refusal.change(scene);
    try
    {
      scene.validate();
      ADD_FAILURE() << refusal.field << " was accepted";
    }
    catch (const ConfigError& error)
    {
      EXPECT_EQ(std::string(error.what()).find(refusal.field), 0U) << error.what();
    }
  }
}

TEST(SceneParams, AcceptsItsPresets)
{
  ASSERT_EQ(presetNames().size(), 2U);
  for (const std::string& name : presetNames())
    EXPECT_NO_THROW(scenePreset(name).validate()) << name;
  EXPECT_THROW(scenePreset("gentle"), ConfigError);
}

TEST(SceneParams, HasTheRealisticPresetThatAccuracyIsJudgedOn)
{
  const SceneParams scene = scenePreset("realistic");
  EXPECT_EQ(scene.sensor.snr, 50.0);
  EXPECT_EQ(scene.laser.sigma_px, 2.0);
  EXPECT_EQ(scene.speckle.contrast, 0.1);
  EXPECT_EQ(scene.speckle.grain_px, 2.0);
  EXPECT_EQ(scene.exposure, 0.005);
  EXPECT_TRUE(scene.motion_blur);
  EXPECT_GT(scene.weld.ripple_height, 0.0);
  const double rest = scene.laser.specular + scene.laser.interreflection + scene.laser.ghost + scene.laser.glow +
                      scene.light.ambient + scene.light.arc + scene.light.flash_share + scene.light.sparks +
                      scene.spatter.count + scene.weld.undercut_left + scene.weld.undercut_right;
  EXPECT_EQ(rest, 0.0) << "none of the rest";
}

TEST(SceneParams, HasEverythingOnInTheHarshPreset)
{
  const SceneParams scene = scenePreset("harsh");
  EXPECT_EQ(scene.speckle.contrast, 0.2);
  for (const double on :
       { scene.laser.specular, scene.laser.interreflection, scene.laser.ghost, scene.laser.glow, scene.light.ambient,
         scene.light.arc, scene.light.flash_share, static_cast<double>(scene.light.sparks),
         static_cast<double>(scene.spatter.count), scene.weld.undercut_left, scene.weld.undercut_right,
         scene.plates.misalignment, scene.plates.angle_deg, scene.gauge.height, scene.weld.ripple_height,
         scene.speed_variation })
    EXPECT_GT(on, 0.0);
}

class SceneFile : public ::testing::Test
{
protected:
  void SetUp() override { path_ = "/tmp/scene_" + std::to_string(getpid()) + ".yaml"; }
  void TearDown() override { std::remove(path_.c_str()); }

  SceneParams load(const std::string& text)
  {
    std::ofstream(path_) << text;
    return loadScene(path_);
  }

  std::string refusal(const std::string& text)
  {
    try
    {
      load(text);
    }
    catch (const Error& error)
    {
      return error.what();
    }
    return "accepted";
  }

  std::string path_;
};

TEST_F(SceneFile, StartsFromAPresetAndSetsWhatItNames)
{
  const SceneParams scene = load(
      "preset: harsh\nspeed: 0.01\nweld: {width: 0.012}\nlaser: {ghost: 0}\n"
      "camera: {roi: {x_offset: 10, y_offset: 20, width: 400, height: 300}}\n"
      "stage: {joint: rail}\n");
  EXPECT_EQ(scene.speed, 0.01);
  EXPECT_EQ(scene.weld.width, 0.012);
  EXPECT_EQ(scene.weld.undercut_left, scenePreset("harsh").weld.undercut_left);
  EXPECT_EQ(scene.laser.ghost, 0.0);
  EXPECT_EQ(scene.calibration.camera.roi_height, 300);
  EXPECT_EQ(scene.calibration.camera.fx, 6000.0);
  EXPECT_EQ(scene.calibration.stage.joint, "rail");
}

TEST_F(SceneFile, IsRealisticWhenEmpty)
{
  const SceneParams scene = load("");
  EXPECT_EQ(scene.weld.ripple_height, scenePreset("realistic").weld.ripple_height);
}

TEST_F(SceneFile, RefusesUnknownKeysOnEveryLevel)
{
  EXPECT_NE(refusal("sped: 1\n").find("unknown parameter 'sped'"), std::string::npos);
  EXPECT_NE(refusal("weld: {widht: 1}\n").find("weld: unknown parameter 'widht'"), std::string::npos);
  EXPECT_NE(refusal("camera: {roi: {x: 1}}\n").find("unknown parameter 'x'"), std::string::npos);
  EXPECT_NE(refusal("stage: {axes: [0, 1, 0]}\n").find("'axes'"), std::string::npos);
}

TEST_F(SceneFile, NamesFileAndFieldOfWhatItRefuses)
{
  EXPECT_EQ(refusal("speed: fast\n"), path_ + ": speed has the wrong type, must be a number");
  EXPECT_EQ(refusal("weld: 3\n").find(path_ + ": weld"), 0U);
  EXPECT_EQ(refusal("weld: {width: 1}\n").find(path_ + ": weld.width is 1"), 0U);
  EXPECT_EQ(refusal("preset: gentle\n").find(path_ + ": preset is 'gentle'"), 0U);
  EXPECT_NE(refusal("speed: [1\n").find("not a YAML file"), std::string::npos);
  EXPECT_NE(refusal("camera: {distortion_model: fisheye}\n").find("plumb_bob"), std::string::npos);
  EXPECT_NE(refusal("camera: {camera_matrix: [1, 2, 3, 4, 5, 6, 7, 8, 9]}\n").find("camera_matrix"), std::string::npos);
  EXPECT_THROW(loadScene("/nowhere/scene.yaml"), InputError);
}

TEST_F(SceneFile, ComesBackAsItWasSaved)
{
  SceneParams scene = scenePreset("harsh");
  scene.seed = 123456789012345ULL;
  scene.speed = 0.1 / 3.0;
  scene.motion = "tf";
  scene.calibration.camera.roi_x = 16;
  scene.calibration.camera.roi_width = 800;
  scene.calibration.camera.roi_height = 600;
  saveScene(scene, path_);
  const SceneParams back = loadScene(path_);
  EXPECT_EQ(back.seed, scene.seed);
  EXPECT_EQ(back.speed, scene.speed);
  EXPECT_EQ(back.motion, "tf");
  EXPECT_EQ(back.part_moves, scene.part_moves);
  EXPECT_EQ(back.light.sparks, scene.light.sparks);
  EXPECT_EQ(back.laser.interreflection, scene.laser.interreflection);
  EXPECT_EQ(back.calibration.camera.distortion, scene.calibration.camera.distortion);
  EXPECT_EQ(back.calibration.camera.roi_width, 800);
  EXPECT_EQ(back.calibration.laser_plane.normal, scene.calibration.laser_plane.normal);
  EXPECT_THROW(saveScene(scene, "/nowhere/scene.yaml"), InputError);
}

TEST(SceneFiles, ThatComeWithThePackageLoad)
{
  for (const char* name : { "realistic", "harsh", "chiral", "chiral_part_moves", "chiral_tf", "filter_on", "filter_off",
                            "fillet", "bead_on_plate", "tacks", "incomplete_fill" })
    EXPECT_NO_THROW(loadScene(std::string("config/scenes/") + name + ".yaml")) << name;
}
}  // namespace
}  // namespace weld_profiler
