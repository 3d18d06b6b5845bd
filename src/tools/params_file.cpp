#include "tools/params_file.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include "weld_profiler/core/errors.h"
#include "weld_profiler/core/utf8.h"

namespace weld_profiler
{
namespace
{
const std::set<std::string>& sections()
{
  static const std::set<std::string> names = { "camera",        "simulated_rig", "stage_encoder",
                                               "stripe_centre", "triangulation", "weld_measurement" };
  return names;
}

std::string listOf(const std::set<std::string>& names)
{
  std::string list;
  for (const std::string& name : names)
    list += (list.empty() ? "" : ", ") + name;
  return list;
}

YAML::Node parse(const std::string& path)
{
  errno = 0;
  std::ifstream file(path);
  if (!file)
    throw InputError(path + ": cannot be read: " + std::strerror(errno != 0 ? errno : EIO));
  if (file.peek() == std::ifstream::traits_type::eof())
    throw InputError(path + ": is empty, expected `name: value` lines");
  std::ostringstream text;
  text << file.rdbuf();
  if (!isUtf8(text.str()))
    throw InputError(path + ": is no UTF-8 text, save it as such");
  try
  {
    return YAML::Load(text.str());
  }
  catch (const YAML::Exception& error)
  {
    throw ConfigError(path + ": line " + std::to_string(error.mark.line + 1) + " is not YAML: " + error.msg);
  }
}
}  // namespace

ParamsFile::ParamsFile(const std::string& path) : path_(path)
{
  if (path.empty())
    return;
  root_ = parse(path);
  if (root_.IsNull())
    return;
  if (!root_.IsMap())
    throw ConfigError(path + ": expected `name: value` lines");
  std::string stranger;
  for (const auto& entry : root_)
  {
    const std::string key = entry.first.as<std::string>("");
    if (sections().count(key) != 0)
      sectioned_ = true;
    else
      stranger = key;
  }
  if (sectioned_ && !stranger.empty())
    throw ConfigError(path + ": unknown section '" + stranger + "', must be one of: " + listOf(sections()));
}

YAML::Node ParamsFile::section(const std::string& nodelet) const
{
  const YAML::Node& root = root_;  // the const operator[] adds nothing to the tree
  return root[nodelet];
}

void ParamsFile::refuseUnknown() const
{
  if (sectioned_ || !root_.IsMap())
    return;
  for (const auto& entry : root_)
  {
    const std::string key = entry.first.as<std::string>("");
    if (known_.count(key) == 0)
      throw ConfigError(path_ + ": unknown parameter '" + key + "', must be one of: " + listOf(known_));
  }
}
}  // namespace weld_profiler
