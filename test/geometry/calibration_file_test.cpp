#include "weld_profiler/geometry/calibration_file.h"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "geometry/temporary_folder.h"
#include "weld_profiler/core/errors.h"

using namespace weld_profiler;

namespace
{
const char* const kCamera = R"(camera:
  image_width: 1440
  image_height: 1080
  camera_matrix: [6000.0, 0.0, 719.5, 0.0, 6100.0, 539.5, 0.0, 0.0, 1.0]
  distortion_model: plumb_bob
  distortion_coefficients: [-0.1, 0.2, 0.001, -0.002, 0.05]
)";

const char* const kRest = R"(laser_plane:
  normal: [0.0, 0.8660254, 0.5]
  distance: 0.125
stage:
  type: linear
  joint: stage_joint
  axis: [0.0, -0.8660254, -0.5]
  metres_per_unit: 0.001
)";

std::string goodFile()
{
  return std::string("version: 1\n") + kCamera + kRest;
}

std::string replaced(std::string text, const std::string& old_text, const std::string& new_text)
{
  const std::size_t at = text.find(old_text);
  EXPECT_NE(at, std::string::npos) << old_text;
  return at == std::string::npos ? text : text.replace(at, old_text.size(), new_text);
}

/// The error that loading the text gives; empty when it loads.
std::string errorOf(const std::string& text)
{
  const TemporaryFolder folder;
  writeText(folder.file("rig.yaml"), text);
  try
  {
    loadCalibration(folder.file("rig.yaml"));
  }
  catch (const ConfigError& error)
  {
    return error.what();
  }
  return "";
}

struct Refusal
{
  const char* name;
  const char* old_text;
  const char* new_text;
  std::vector<const char*> says;  ///< key, value and remedy
};

std::ostream& operator<<(std::ostream& out, const Refusal& refusal)
{
  return out << refusal.name;
}

const std::vector<Refusal> kRefusals = {
  { "UnknownVersion", "version: 1", "version: 2", { "version", "2", "must be 1" } },
  { "MissingVersion", "version: 1\n", "", { "version", "missing", "add" } },
  { "VersionOfWrongType", "version: 1", "version: new", { "version", "new", "must be 1" } },
  { "MissingCamera", "camera:\n", "camara:\n", { "camera", "missing", "camera_info_url" } },
  { "CameraThatIsNoSection", kCamera, "camera: yes\n", { "camera", "not a section" } },
  { "MissingMatrix", "camera_matrix", "matrix", { "camera.camera_matrix", "missing", "9 numbers" } },
  { "ShortMatrix", "0.0, 1.0]", "1.0]", { "camera.camera_matrix", "8", "9 numbers" } },
  { "ZeroMatrix", "[6000.0", "[0.0", { "camera.camera_matrix fx", "0", "must be in" } },
  { "SkewedMatrix", "[6000.0, 0.0", "[6000.0, 1.0", { "camera.camera_matrix", "[fx, 0, cx" } },
  { "NanInMatrix", "719.5", ".nan", { "camera.camera_matrix cx", "nan", "must be in" } },
  { "WidthOfWrongType", "1440", "wide", { "camera.image_width", "wide", "whole number" } },
  { "NoWidth", "1440", "0", { "camera.image_width", "0", "must be in" } },
  { "NegativeHeight", "1080", "-1080", { "camera.image_height", "-1080", "must be in" } },
  { "UnknownDistortionModel", "plumb_bob", "equidistant", { "camera.distortion_model", "equidistant", "plumb_bob" } },
  { "FourCoefficients", ", 0.05]", "]", { "camera.distortion_coefficients", "4", "5 numbers" } },
  { "NanCoefficient", "0.05]", ".nan]", { "camera.distortion_coefficients", "nan", "k1 k2 p1 p2 k3" } },
  { "TextForCoefficient", "0.05]", "small]", { "camera.distortion_coefficients", "small", "5 numbers" } },
  { "RoiOffTheSensor",
    "laser_plane:",
    "  roi: {x_offset: 800, y_offset: 0, width: 641, height: 10}\nlaser_plane:",
    { "camera.roi width", "641", "640" } },
  { "RoiWithoutKey", "laser_plane:", "  roi: {x_offset: 800}\nlaser_plane:", { "camera.roi.y_offset", "missing" } },
  { "NegativeBinning", "laser_plane:", "  binning_x: -2\nlaser_plane:", { "camera.binning_x", "-2", "must be in" } },
  { "MissingPlane", "laser_plane:", "laser:", { "laser_plane", "missing", "add" } },
  { "ZeroNormal", "[0.0, 0.8660254, 0.5]", "[0, 0, 0]", { "laser_plane.normal", "[0, 0, 0]", "zero", "unit vector" } },
  { "NormalNotUnit", "0.8660254, 0.5]", "0.8660254, 0.51]", { "laser_plane.normal", "0.51", "unit vector", "1e-3" } },
  { "NanInNormal", "[0.0, 0.8660254, 0.5]", "[.nan, 0.8660254, 0.5]", { "laser_plane.normal", "nan", "finite" } },
  { "TwoNumbersForNormal", "[0.0, 0.8660254, 0.5]", "[0.0, 1.0]", { "laser_plane.normal", "2", "3 numbers" } },
  { "NanDistance", "0.125", ".nan", { "laser_plane.distance", "nan", "finite" } },
  { "PlaneBehindTheCamera", "0.125", "-0.125", { "laser_plane", "-0.125", "in front of the camera" } },
  { "PlaneThroughTheCamera", "0.125", "0", { "laser_plane", "in front of the camera" } },
  { "MissingDistance", "distance:", "offset:", { "laser_plane.distance", "missing", "add" } },
  { "RotaryStage", "type: linear", "type: rotary", { "stage.type", "rotary", "must be linear" } },
  { "UnknownStage", "type: linear", "type: conveyor", { "stage.type", "conveyor", "must be linear" } },
  { "MissingJoint", "joint: stage_joint", "name: x", { "stage.joint", "missing", "JointState" } },
  { "EmptyJoint", "joint: stage_joint", "joint: ''", { "stage.joint", "JointState" } },
  { "AxisNotUnit", "-0.8660254, -0.5]", "-0.8660254, -0.502]", { "stage.axis", "-0.502", "unit vector" } },
  { "NanAxis", "-0.8660254, -0.5]", "-0.8660254, .nan]", { "stage.axis", "nan", "finite" } },
  { "AxisInThePlane",
    "[0.0, -0.8660254, -0.5]",
    "[1.0, 0.0, 0.0]",
    { "laser_plane.normal . stage.axis", "0", "5 deg", "check" } },
  { "AxisFourDegreesOffThePlane",
    "[0.0, -0.8660254, -0.5]",
    "[0.99756405, 0.06040977, 0.03487824]",
    { "laser_plane.normal . stage.axis", "5 deg" } },
  { "AxisAlongTheOpticalAxis",
    "[0.0, -0.8660254, -0.5]",
    "[0.0697565, 0.0, -0.9975641]",
    { "stage.axis", "optical axis", "check" } },
  { "ZeroMetresPerUnit", "unit: 0.001", "unit: 0", { "stage.metres_per_unit", "0", "greater than 0", "axis" } },
  { "NegativeMetresPerUnit", "unit: 0.001", "unit: -1", { "stage.metres_per_unit", "-1", "greater than 0" } },
  { "NanMetresPerUnit", "unit: 0.001", "unit: .nan", { "stage.metres_per_unit", "nan", "greater than 0" } },
  { "InfiniteMetresPerUnit", "unit: 0.001", "unit: .inf", { "stage.metres_per_unit", "inf" } },
  { "MalformedYaml", "  distance: 0.125", " \tdistance: ]0.125", { "line 10", "malformed YAML" } },
};

class RefusedCalibration : public ::testing::TestWithParam<Refusal>
{
};
}  // namespace

TEST_P(RefusedCalibration, SaysFileKeyValueAndRemedyInOneLine)
{
  const std::string error = errorOf(replaced(goodFile(), GetParam().old_text, GetParam().new_text));
  ASSERT_FALSE(error.empty()) << "it was loaded";
  EXPECT_NE(error.find("rig.yaml: "), std::string::npos) << error;
  EXPECT_EQ(error.find('\n'), std::string::npos) << error;
  for (const char* word : GetParam().says)
    EXPECT_NE(error.find(word), std::string::npos) << "'" << word << "' is not in: " << error;
}

INSTANTIATE_TEST_SUITE_P(EachRule, RefusedCalibration, ::testing::ValuesIn(kRefusals),
                         [](const auto& info) { return std::string(info.param.name); });

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
