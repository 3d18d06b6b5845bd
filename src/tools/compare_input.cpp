#include "tools/compare_input.h"

#include <filesystem>

#include <yaml-cpp/yaml.h>

#include "weld_profiler/core/errors.h"
#include "weld_profiler/core/yaml_fields.h"
#include "weld_profiler/scan/scan_file.h"

namespace weld_profiler
{
namespace
{
namespace fs = std::filesystem;

std::string textOf(const YAML::Node& map, const char* key)
{
  return map.IsMap() && map[key] && map[key].IsScalar() ? map[key].Scalar() : "";
}

void readRecord(const std::string& path, CompareSource& source)
{
  YAML::Node record;
  try
  {
    record = YAML::LoadFile(path);  // JSON is YAML
  }
  catch (const YAML::Exception& error)
  {
    throw InputError(path + ": is damaged: " + error.msg + ", measure the scan again or give its scan.pcd alone");
  }
  if (!record.IsMap())
    throw InputError(path + ": is no record of a weld, measure the scan again or give its scan.pcd alone");
  source.weld_id = textOf(record, "id");
  source.scan.frame_id = textOf(record, "frame_id");
  if (record["calibration"])
    source.calibration = { textOf(record["calibration"], "file"), textOf(record["calibration"], "hash"),
                           textOf(record["calibration"], "date") };
  YamlFields fields(record["settings"], path + ": settings");
  source.measuring.visit(fields);
  try
  {
    source.measuring.validate();
  }
  catch (const ConfigError& error)
  {
    throw ConfigError(path + ": settings: " + error.what());
  }
}
}  // namespace

CompareSource readCompareSource(const std::string& path)
{
  CompareSource source;
  source.path = path;
  std::error_code error;
  if (!fs::is_directory(path, error))
  {
    source.scan = loadScan(path);
    return source;
  }
  const fs::path folder(path);
  fs::path cloud = folder / "scan.pcd";
  if (!fs::exists(cloud, error))
    cloud = folder / "weld_points.pcd";
  if (!fs::exists(cloud, error))
    throw InputError(path +
                     ": holds neither scan.pcd nor weld_points.pcd, give a folder that scan_bag has filled or a "
                     "PCD file");
  source.scan = loadScan(cloud.string());
  const fs::path record = folder / "weld.json";
  if (fs::exists(record, error))
    readRecord(record.string(), source);
  return source;
}
}  // namespace weld_profiler
