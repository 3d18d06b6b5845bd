#pragma once

#include <set>
#include <sstream>
#include <string>
#include <type_traits>

#include <yaml-cpp/yaml.h>

#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
/// Reads the fields of a parameter struct from a YAML map. A struct offers its fields to any visitor through
/// `template <class V> void visit(V&& v) { v("name", member); ... }`, so names stand in one place only.
/// A field that is not in the file keeps its value; a wrong type is an error naming file, key and type.
class YamlFields
{
public:
  /// @param map     a YAML map; undefined or null = nothing set.
  /// @param origin  file name, for messages.
  YamlFields(const YAML::Node& map, std::string origin) : map_(map), origin_(std::move(origin))
  {
    if (map_ && !map_.IsNull() && !map_.IsMap())
      throw ConfigError(origin_ + ": expected `name: value` lines");
  }

  template <class T>
  void operator()(const std::string& name, T& value)
  {
    known_.insert(name);
    if (!map_ || !map_.IsMap() || !map_[name])
      return;
    const YAML::Node node = map_[name];
    try
    {
      if (std::is_same<T, std::string>::value && !node.IsScalar())
        throw YAML::RepresentationException(node.Mark(), "not a scalar");
      value = node.as<T>();
    }
    catch (const YAML::Exception&)
    {
      throw ConfigError(origin_ + ": " + name + " has the wrong type, must be " + typeName<T>());
    }
  }

  /// @throws ConfigError naming the first key of the file that no field asked for, and the known ones.
  void refuseUnknown() const
  {
    if (!map_ || !map_.IsMap())
      return;
    for (const auto& entry : map_)
    {
      const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : "(not a name)";
      if (known_.count(key) != 0)
        continue;
      std::string list;
      for (const std::string& name : known_)
      {
        if (!list.empty())
          list += ", ";
        list += name;
      }
      std::ostringstream text;
      text << origin_ << ": unknown parameter '" << key << "', must be one of: " << list;
      throw ConfigError(text.str());
    }
  }

private:
  template <class T>
  static std::string typeName()
  {
    if (std::is_same<T, bool>::value)
      return "true or false";
    if (std::is_same<T, std::string>::value)
      return "text";
    if (std::is_integral<T>::value)
      return "a whole number";
    if (std::is_floating_point<T>::value)
      return "a number";
    return "a list of numbers";
  }

  YAML::Node map_;
  std::string origin_;
  std::set<std::string> known_;
};
}  // namespace weld_profiler
