#include "weld_profiler/geometry/calibration_file.h"

#include <array>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "geometry/calibration_text.h"
#include "geometry/temporary_folder.h"
#include "weld_profiler/core/errors.h"

using namespace weld_profiler;

TEST(CalibrationFile, HoldsWhatItSays)
{
  const TemporaryFolder folder;
  writeText(folder.file("rig.yaml"), goodFile());
  const Calibration rig = loadCalibration(folder.file("rig.yaml"));
  EXPECT_EQ(rig.camera.image_width, 1440);
  EXPECT_EQ(rig.camera.image_height, 1080);
  EXPECT_EQ(rig.camera.fx, 6000.0);
  EXPECT_EQ(rig.camera.fy, 6100.0);
  EXPECT_EQ(rig.camera.cx, 719.5);
  EXPECT_EQ(rig.camera.cy, 539.5);
  EXPECT_EQ(rig.camera.distortion, (std::array<double, 5>{ { -0.1, 0.2, 0.001, -0.002, 0.05 } }));
  EXPECT_NEAR(rig.laser_plane.normal[1], 0.8660254, 1e-7);
  EXPECT_NEAR(rig.laser_plane.distance, 0.125, 1e-8);
  EXPECT_EQ(rig.stage.joint, "stage_joint");
  EXPECT_EQ(rig.stage.metres_per_unit, 0.001);
  EXPECT_EQ(cameraInfoUrl(folder.file("rig.yaml")), "");
}

TEST(CalibrationFile, OfTheDefaultRigIsTheDefaultCalibration)
{
  const Calibration rig = loadCalibration("config/rigs/default/calibration.yaml");
  EXPECT_EQ(calibrationText(rig), calibrationText(Calibration{}));
}

TEST(CalibrationFile, MakesVectorsUnitAndLeavesThePlaneWhereItIs)
{
  Calibration rig;
  for (double& component : rig.laser_plane.normal)
    component *= 1.0005;
  rig.laser_plane.distance *= 1.0005;
  validateCalibration(rig, "test");
  EXPECT_NEAR(rig.laser_plane.normal[2], 0.5, 1e-15);
  EXPECT_NEAR(rig.laser_plane.distance, 0.125, 1e-15);
  const Calibration once = rig;
  validateCalibration(rig, "test");
  EXPECT_EQ(once.laser_plane.normal, rig.laser_plane.normal) << "a second validation moves nothing";
}

TEST(CalibrationFile, AcceptsKeysItDoesNotKnow)
{
  EXPECT_EQ(errorOf("date: 2024-05-01\ntool: {name: calibrate, version: 3}\n" + goodFile() +
                    "covariance: [1, 2, 3]\nresiduals: {rms_px: 0.1}\nroi: whole\n"),
            "");
}

TEST(CalibrationFile, ReadsBackTheVeryValuesThatWereSaved)
{
  Calibration rig;
  rig.camera.fx = 6000.0 / 3.0 + 1e-9;
  rig.camera.distortion = { { -0.1, 1.0 / 3.0, 1e-17, -2e-3, 0.05 } };
  rig.camera.roi_x = 16;
  rig.camera.roi_y = 8;
  rig.camera.roi_width = 640;
  rig.camera.roi_height = 480;
  rig.camera.binning_x = 2;
  rig.laser_plane.distance = 0.1 + 0.2;
  rig.stage.joint = "axis: 1 #x";
  rig.stage.metres_per_unit = 1e-3 / 3.0;
  validateCalibration(rig, "test");
  const TemporaryFolder folder;
  saveCalibration(rig, folder.file("rig.yaml"));
  const Calibration back = loadCalibration(folder.file("rig.yaml"));
  EXPECT_EQ(back.camera.fx, rig.camera.fx);
  EXPECT_EQ(back.camera.distortion, rig.camera.distortion);
  EXPECT_EQ(back.camera.roi_width, 640);
  EXPECT_EQ(back.camera.binning_x, 2);
  EXPECT_EQ(back.laser_plane.normal, rig.laser_plane.normal);
  EXPECT_EQ(back.laser_plane.distance, rig.laser_plane.distance);
  EXPECT_EQ(back.stage.joint, "axis: 1 #x");
  EXPECT_EQ(back.stage.metres_per_unit, rig.stage.metres_per_unit);
  EXPECT_EQ(calibrationText(back), calibrationText(rig));
  EXPECT_EQ(folder.entries(), 1u);
}

TEST(CalibrationFile, IsNotSavedWhenItWouldNotLoad)
{
  const TemporaryFolder folder;
  Calibration rig;
  rig.stage.metres_per_unit = std::nan("");
  EXPECT_THROW(saveCalibration(rig, folder.file("rig.yaml")), ConfigError);
  EXPECT_THROW(saveCalibration(Calibration{}, folder.file("nowhere/rig.yaml")), InputError);
  EXPECT_EQ(folder.entries(), 0u);
}

TEST(CalibrationFile, SaysWhichFileCannotBeRead)
{
  for (const std::string path : { "/nonexistent/rig.yaml", "/" })
    try
    {
      loadCalibration(path);
      FAIL() << path;
    }
    catch (const InputError& error)
    {
      EXPECT_NE(std::string(error.what()).find(path), std::string::npos) << error.what();
    }
  EXPECT_NE(errorOf("").find("rig.yaml"), std::string::npos) << "an empty file";
  EXPECT_NE(errorOf("just words").find("rig.yaml"), std::string::npos);
}

namespace
{
const char* const kRosCamera = R"(image_width: 1440
image_height: 1080
camera_name: head
camera_matrix:
  rows: 3
  cols: 3
  data: [5000, 0, 700, 0, 5001, 500, 0, 0, 1]
distortion_model: plumb_bob
distortion_coefficients:
  rows: 1
  cols: 5
  data: [0.1, 0.2, 0.3, 0.4, 0.5]
rectification_matrix: {rows: 3, cols: 3, data: [1, 0, 0, 0, 1, 0, 0, 0, 1]}
)";

std::string withUrl(const std::string& url)
{
  return "version: 1\ncamera_info_url: " + url + "\n" + kRest;
}
}  // namespace

TEST(CameraInfoUrl, IsRelativeToTheCalibrationFile)
{
  const TemporaryFolder folder;
  writeText(folder.file("head.yaml"), replaced(kRosCamera, "[0.1, 0.2, 0.3, 0.4, 0.5]", "[0.1, 0, 0, 0, 0]"));
  for (const std::string& url :
       { std::string("head.yaml"), folder.file("head.yaml"), "file://" + folder.file("head.yaml") })
  {
    writeText(folder.file("rig.yaml"), withUrl(url));
    const Calibration rig = loadCalibration(folder.file("rig.yaml"));
    EXPECT_EQ(rig.camera.fx, 5000.0);
    EXPECT_EQ(rig.camera.fy, 5001.0);
    EXPECT_EQ(rig.camera.distortion[0], 0.1);
    EXPECT_EQ(cameraInfoUrl(folder.file("rig.yaml")), url);
  }
}

TEST(CameraInfoUrl, GoesThroughTheResolverWhenItNamesAPackage)
{
  const TemporaryFolder folder;
  writeText(folder.file("head.yaml"), kRosCamera);
  writeText(folder.file("rig.yaml"), withUrl("package://my_cell/head.yaml"));
  const auto resolve = [&](const std::string& url)
  {
    EXPECT_EQ(url, "package://my_cell/head.yaml");
    return folder.file("head.yaml");
  };
  EXPECT_EQ(loadCalibration(folder.file("rig.yaml"), resolve).camera.fx, 5000.0);
  EXPECT_NE(errorOf(withUrl("package://my_cell/head.yaml")).find("relative to this file"), std::string::npos);
}

TEST(CameraInfoUrl, IsRefusedWhenItIsUnusable)
{
  EXPECT_NE(errorOf(withUrl("http://x/head.yaml")).find("http://x/head.yaml"), std::string::npos);
  EXPECT_NE(errorOf(withUrl("head.yaml") + kCamera).find("keep one"), std::string::npos);
  const TemporaryFolder folder;
  writeText(folder.file("rig.yaml"), withUrl("absent.yaml"));
  EXPECT_THROW(loadCalibration(folder.file("rig.yaml")), InputError);
  writeText(folder.file("absent.yaml"), replaced(kRosCamera, "plumb_bob", "rational_polynomial"));
  try
  {
    loadCalibration(folder.file("rig.yaml"));
    FAIL();
  }
  catch (const ConfigError& error)
  {
    EXPECT_NE(std::string(error.what()).find("absent.yaml"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("rational_polynomial"), std::string::npos) << error.what();
  }
}
