#pragma once

#include <set>
#include <string>
#include <vector>

#include <ros/node_handle.h>

#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
/// Reads the fields of a parameter struct from a NodeHandle: the visitor of the structs' visit(). A parameter that is
/// not set keeps its default; a wrong type is an error, never the default.
class NodeParams
{
public:
  explicit NodeParams(const ros::NodeHandle& node) : node_(node) {}

  template <class T>
  void operator()(const std::string& name, T& value)
  {
    known_.insert(node_.resolveName(name));
    if (node_.hasParam(name) && !node_.getParam(name, value))
      throw ConfigError("parameter " + node_.resolveName(name) + " has the wrong type");
  }

  /// @throws ConfigError when it is missing or empty; remedy says what to set.
  void required(const std::string& name, std::string& value, const std::string& remedy)
  {
    (*this)(name, value);
    if (value.empty())
      throw ConfigError("parameter " + node_.resolveName(name) + " is not set, must be " + remedy);
  }

  /// Parameters that are set in the private namespace and that nobody asked for: a misspelt name, most likely.
  std::vector<std::string> unknown() const
  {
    std::vector<std::string> names;
    std::vector<std::string> all;
    node_.getParamNames(all);
    const std::string prefix = node_.getNamespace() + "/";
    for (const std::string& name : all)
    {
      if (name.compare(0, prefix.size(), prefix) == 0 && known_.count(name) == 0)
        names.push_back(name);
    }
    return names;
  }

private:
  ros::NodeHandle node_;
  std::set<std::string> known_;
};
}  // namespace weld_profiler
