#include "weld_profiler/geometry/calibration_file.h"

#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <vector>

#include <yaml-cpp/yaml.h>

#include "weld_profiler/core/atomic_file.h"
#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
namespace
{
/// A map of the file, and where it stands: for messages "FILE: stage.axis ...".
struct Section
{
  YAML::Node node;
  std::string file;
  std::string prefix;  ///< "stage." or empty

  std::string name(const std::string& key) const { return file + ": " + prefix + key; }
  bool has(const std::string& key) const { return node[key].IsDefined() && !node[key].IsNull(); }
};

YAML::Node parse(const std::string& path)
{
  std::ostringstream content;
  std::ifstream stream(path, std::ios::binary);
  // a folder opens, but is not read
  if (!stream || std::filesystem::is_directory(path) || !(content << stream.rdbuf() || stream.peek() == EOF))
    throw InputError("cannot read calibration file " + path + ": no such file or not readable, check the path");
  try
  {
    const YAML::Node root = YAML::Load(content.str());
    if (!root.IsMap())
      throw ConfigError(path + ": holds no `key: value` lines, must be a calibration file");
    return root;
  }
  catch (const YAML::Exception& error)
  {
    throw ConfigError(path + ": line " + std::to_string(error.mark.line + 1) + ": malformed YAML (" + error.msg +
                      "), correct that line");
  }
}

template <class T>
T read(const Section& section, const std::string& key, const char* type)
{
  if (!section.has(key))
    throw ConfigError(section.name(key) + " is missing, add `" + key + ": ` " + type);
  try
  {
    return section.node[key].as<T>();
  }
  catch (const YAML::Exception&)
  {
    std::ostringstream value;
    value << section.node[key];
    throw ConfigError(section.name(key) + " is '" + value.str() + "', must be " + type);
  }
}

Section child(const Section& parent, const std::string& key)
{
  if (!parent.has(key))
    throw ConfigError(parent.name(key) + " is missing, add the section `" + key + ":`");
  if (!parent.node[key].IsMap())
    throw ConfigError(parent.name(key) + " is not a section, must hold indented `key: value` lines");
  return Section{ parent.node[key], parent.file, parent.prefix + key + "." };
}

/// A list of numbers: `[...]`, or ROS's `rows, cols, data: [...]`.
std::vector<double> readNumbers(const Section& section, const std::string& key, std::size_t count)
{
  const std::string type = "a list of " + std::to_string(count) + " numbers";
  const bool as_ros = section.has(key) && section.node[key].IsMap();
  auto values = as_ros ? read<std::vector<double>>(child(section, key), "data", type.c_str())
                       : read<std::vector<double>>(section, key, type.c_str());
  if (values.size() != count)
    throw ConfigError(section.name(key) + " has " + std::to_string(values.size()) + " numbers, must be " + type);
  return values;
}

std::array<double, 3> readVector(const Section& section, const std::string& key)
{
  const std::vector<double> values = readNumbers(section, key, 3);
  return { { values[0], values[1], values[2] } };
}

void readMatrix(const Section& section, CameraCalibration& camera)
{
  const std::vector<double> k = readNumbers(section, "camera_matrix", 9);
  if (!(k[1] == 0.0 && k[3] == 0.0 && k[6] == 0.0 && k[7] == 0.0 && k[8] == 1.0))
    throw ConfigError(section.name("camera_matrix") + " is not [fx, 0, cx, 0, fy, cy, 0, 0, 1], write it row by row");
  camera.fx = k[0];
  camera.cx = k[2];
  camera.fy = k[4];
  camera.cy = k[5];
}

void readRoi(const Section& section, CameraCalibration& camera)
{
  const char* type = "a whole number of sensor pixels";
  const Section roi = child(section, "roi");
  camera.roi_x = read<int>(roi, "x_offset", type);
  camera.roi_y = read<int>(roi, "y_offset", type);
  camera.roi_width = read<int>(roi, "width", type);
  camera.roi_height = read<int>(roi, "height", type);
}

CameraCalibration readCamera(const Section& section)
{
  CameraCalibration camera;
  camera.image_width = read<int>(section, "image_width", "a whole number of pixels");
  camera.image_height = read<int>(section, "image_height", "a whole number of pixels");
  readMatrix(section, camera);
  const auto model = read<std::string>(section, "distortion_model", "plumb_bob");
  if (model != "plumb_bob")
    throw ConfigError(section.name("distortion_model") + " is '" + model + "', must be plumb_bob");
  const std::vector<double> d = readNumbers(section, "distortion_coefficients", 5);
  camera.distortion = { { d[0], d[1], d[2], d[3], d[4] } };
  // 0 stands for 1 in CameraInfo
  camera.binning_x = section.has("binning_x") ? read<int>(section, "binning_x", "a whole number") : 1;
  camera.binning_y = section.has("binning_y") ? read<int>(section, "binning_y", "a whole number") : 1;
  camera.binning_x += camera.binning_x == 0 ? 1 : 0;
  camera.binning_y += camera.binning_y == 0 ? 1 : 0;
  if (section.has("roi"))
    readRoi(section, camera);
  return camera;
}

std::string resolveUrl(const std::string& url, const std::string& calibration_path, const UrlResolver& resolve)
{
  if (url.rfind("package://", 0) == 0)
  {
    if (!resolve)
      throw ConfigError(calibration_path + ": camera_info_url is '" + url +
                        "', package:// is known to nodelets only; give a path relative to this file");
    return resolve(url);
  }
  if (url.rfind("file://", 0) == 0)
    return url.substr(7);
  if (url.find("://") != std::string::npos)
    throw ConfigError(calibration_path + ": camera_info_url is '" + url + "', must be a path, file:// or package://");
  return (std::filesystem::path(calibration_path).parent_path() / url).string();  // an absolute url stays as it is
}

void requireVersion(const Section& root)
{
  const int version = read<int>(root, "version", "1");
  if (version != 1)
    throw ConfigError(root.name("version") + " is " + std::to_string(version) + ", must be 1");
}
}  // namespace

CameraCalibration loadCameraFile(const std::string& path)
{
  const CameraCalibration camera = readCamera(Section{ parse(path), path, "" });
  validateCamera(camera, path);
  return camera;
}

std::string cameraInfoUrl(const std::string& calibration_path)
{
  const Section root{ parse(calibration_path), calibration_path, "" };
  return root.has("camera_info_url") ? read<std::string>(root, "camera_info_url", "a path or URL") : "";
}

Calibration loadCalibration(const std::string& path, const UrlResolver& resolve)
{
  const Section root{ parse(path), path, "" };
  requireVersion(root);
  if (root.has("camera") == root.has("camera_info_url"))
    throw ConfigError(path + (root.has("camera") ? ": has both camera and camera_info_url, keep one of them"
                                                 : ": camera is missing, add `camera:` or `camera_info_url:`"));
  Calibration calibration;
  if (root.has("camera"))
    calibration.camera = readCamera(child(root, "camera"));
  else
    calibration.camera =
        loadCameraFile(resolveUrl(read<std::string>(root, "camera_info_url", "a path or URL"), path, resolve));

  const Section plane = child(root, "laser_plane");
  calibration.laser_plane.normal = readVector(plane, "normal");
  calibration.laser_plane.distance = read<double>(plane, "distance", "a number of metres");

  const Section stage = child(root, "stage");
  calibration.stage.type = read<std::string>(stage, "type", "linear");
  if (calibration.stage.type == "linear")
  {
    calibration.stage.joint = read<std::string>(stage, "joint", "a name in JointState");
    calibration.stage.axis = readVector(stage, "axis");
    calibration.stage.metres_per_unit = read<double>(stage, "metres_per_unit", "a number greater than 0");
  }
  validateCalibration(calibration, path);
  return calibration;
}

std::string calibrationText(const Calibration& calibration)
{
  const CameraCalibration& c = calibration.camera;
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out.precision(std::numeric_limits<double>::max_digits10);
  const auto list = [&out](const auto& values)
  {
    const char* separator = "[";
    for (const double value : values)
    {
      out << separator << value;
      separator = ", ";
    }
    out << "]\n";
  };
  out << "version: 1\ncamera:\n  image_width: " << c.image_width << "\n  image_height: " << c.image_height;
  out << "\n  camera_matrix: ";
  list(std::array<double, 9>{ { c.fx, 0.0, c.cx, 0.0, c.fy, c.cy, 0.0, 0.0, 1.0 } });
  out << "  distortion_model: plumb_bob\n  distortion_coefficients: ";
  list(c.distortion);
  out << "  binning_x: " << c.binning_x << "\n  binning_y: " << c.binning_y << "\n  roi: {x_offset: " << c.roi_x
      << ", y_offset: " << c.roi_y << ", width: " << c.roi_width << ", height: " << c.roi_height << "}\n";
  out << "laser_plane:  # points p in the camera optical frame with normal . p = distance [m]\n  normal: ";
  list(calibration.laser_plane.normal);
  out << "  distance: " << calibration.laser_plane.distance << "\nstage:\n  type: " << calibration.stage.type
      << "\n  joint: " << YAML::Dump(YAML::Node(calibration.stage.joint)) << "\n  axis: ";
  list(calibration.stage.axis);
  out << "  metres_per_unit: " << calibration.stage.metres_per_unit << "\n";
  return out.str();
}

void saveCalibration(const Calibration& calibration, const std::string& path)
{
  Calibration checked = calibration;
  validateCalibration(checked, path);
  writeWholeFile(path, calibrationText(checked));
}
}  // namespace weld_profiler
