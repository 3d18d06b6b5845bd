#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "geometry/calibration_text.h"

namespace
{
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
