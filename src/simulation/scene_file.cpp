#include <cstdio>
#include <fstream>

#include <yaml-cpp/yaml.h>

#include "weld_profiler/core/errors.h"
#include "weld_profiler/core/yaml_fields.h"
#include "weld_profiler/simulation/scene_params.h"

namespace weld_profiler
{
namespace
{
/// Offers a calibration to a visitor in the layout of a calibration file.
class CalibrationFields
{
public:
  explicit CalibrationFields(Calibration& calibration) : calibration_(calibration) {}

  template <class V>
  void camera(V&& v)
  {
    CameraCalibration& camera = calibration_.camera;
    std::array<double, 9> matrix{ { camera.fx, 0.0, camera.cx, 0.0, camera.fy, camera.cy, 0.0, 0.0, 1.0 } };
    std::string model = "plumb_bob";
    v("image_width", camera.image_width), v("image_height", camera.image_height), v("camera_matrix", matrix);
    v("distortion_model", model), v("distortion_coefficients", camera.distortion);
    v("binning_x", camera.binning_x), v("binning_y", camera.binning_y);
    if (model != "plumb_bob")
      throw ConfigError("camera.distortion_model is '" + model + "', must be plumb_bob");
    if (matrix[1] != 0.0 || matrix[3] != 0.0 || matrix[6] != 0.0 || matrix[7] != 0.0 || matrix[8] != 1.0)
      throw ConfigError("camera.camera_matrix must be [fx, 0, cx, 0, fy, cy, 0, 0, 1]");
    camera.fx = matrix[0];
    camera.cx = matrix[2];
    camera.fy = matrix[4];
    camera.cy = matrix[5];
  }

  template <class V>
  void region(V&& v)
  {
    CameraCalibration& camera = calibration_.camera;
    v("x_offset", camera.roi_x), v("y_offset", camera.roi_y), v("width", camera.roi_width);
    v("height", camera.roi_height);
  }

  template <class V>
  void plane(V&& v)
  {
    v("normal", calibration_.laser_plane.normal), v("distance", calibration_.laser_plane.distance);
  }

  template <class V>
  void stage(V&& v)
  {
    StageCalibration& stage = calibration_.stage;
    v("type", stage.type), v("joint", stage.joint), v("axis", stage.axis), v("metres_per_unit", stage.metres_per_unit);
  }

private:
  Calibration& calibration_;
};

void readSections(const std::string& origin, YamlFields& top, SceneParams& scene)
{
  const auto section = [&](const std::string& name)
  {
    YAML::Node node;
    top(name, node);
    return YamlFields(node, origin + ": " + name);
  };
  scene.visitSections(
      [&](const std::string& name, auto& values)
      {
        YamlFields fields = section(name);
        values.visit(fields);
        fields.refuseUnknown();
      });
  CalibrationFields calibration(scene.calibration);
  YamlFields camera = section("camera");
  calibration.camera(camera);
  YAML::Node roi;
  camera("roi", roi);
  camera.refuseUnknown();
  YamlFields region(roi, origin + ": camera: roi");
  calibration.region(region);
  region.refuseUnknown();
  YamlFields plane = section("laser_plane");
  calibration.plane(plane);
  plane.refuseUnknown();
  YamlFields stage = section("stage");
  calibration.stage(stage);
  stage.refuseUnknown();
}

YAML::Node parse(const std::string& path)
{
  try
  {
    return YAML::LoadFile(path);
  }
  catch (const YAML::BadFile&)
  {
    throw InputError(path + ": cannot be read, check the path and its permissions");
  }
  catch (const YAML::Exception& error)
  {
    throw ConfigError(path + ": not a YAML file: " + error.what());
  }
}

/// Collects fields into a YAML map with all digits a double has.
class YamlWriter
{
public:
  explicit YamlWriter(YAML::Emitter& out) : out_(out) {}

  template <class T>
  void operator()(const std::string& name, const T& value)
  {
    out_ << YAML::Key << name << YAML::Value << value;
  }

  template <std::size_t N>
  void operator()(const std::string& name, const std::array<double, N>& values)
  {
    out_ << YAML::Key << name << YAML::Value << YAML::Flow << std::vector<double>(values.begin(), values.end());
  }

private:
  YAML::Emitter& out_;
};
}  // namespace

SceneParams loadScene(const std::string& path)
{
  const YAML::Node root = parse(path);
  YamlFields top(root, path);
  std::string preset = "realistic";
  top("preset", preset);
  try
  {
    SceneParams scene = scenePreset(preset);
    scene.visit(top);
    readSections(path, top, scene);
    top.refuseUnknown();
    scene.validate();
    return scene;
  }
  catch (const ConfigError& error)
  {
    const std::string text = error.what();
    throw ConfigError(text.compare(0, path.size(), path) == 0 ? text : path + ": " + text);
  }
}

void saveScene(const SceneParams& scene, const std::string& path)
{
  SceneParams values = scene;
  YAML::Emitter out;
  out.SetDoublePrecision(17);
  YamlWriter writer(out);
  const auto section = [&](const std::string& name, const auto& fill)
  {
    out << YAML::Key << name << YAML::Value << YAML::BeginMap;
    fill();
    out << YAML::EndMap;
  };
  out << YAML::BeginMap;
  values.visit(writer);
  values.visitSections([&](const std::string& name, auto& fields) { section(name, [&] { fields.visit(writer); }); });
  CalibrationFields calibration(values.calibration);
  section("camera",
          [&]
          {
            calibration.camera(writer);
            section("roi", [&] { calibration.region(writer); });
          });
  section("laser_plane", [&] { calibration.plane(writer); });
  section("stage", [&] { calibration.stage(writer); });
  out << YAML::EndMap;
  const std::string part = path + ".part";
  std::ofstream file(part);
  file << out.c_str() << "\n";
  file.close();
  if (!file || std::rename(part.c_str(), path.c_str()) != 0)
  {
    std::remove(part.c_str());
    throw InputError(path + ": cannot be written, check the folder, its permissions and the free space");
  }
}
}  // namespace weld_profiler
