#include "weld_profiler/ros/calibration_url.h"

#include <ros/package.h>

#include "weld_profiler/core/errors.h"
#include "weld_profiler/geometry/calibration_file.h"

namespace weld_profiler
{
std::string resolveUrl(const std::string& url)
{
  const std::string package_scheme = "package://";
  const std::string file_scheme = "file://";
  if (url.compare(0, file_scheme.size(), file_scheme) == 0)
    return url.substr(file_scheme.size());
  if (url.compare(0, package_scheme.size(), package_scheme) != 0)
    return url;
  const std::string rest = url.substr(package_scheme.size());
  const std::size_t slash = rest.find('/');
  const std::string package = rest.substr(0, slash);
  const std::string path = ros::package::getPath(package);
  if (path.empty())
    throw ConfigError(url + ": package '" + package + "' is not found, source its workspace or give a path");
  return slash == std::string::npos ? path : path + rest.substr(slash);
}

Calibration loadCalibrationFrom(const std::string& url)
{
  return loadCalibration(resolveUrl(url), resolveUrl);
}
}  // namespace weld_profiler
