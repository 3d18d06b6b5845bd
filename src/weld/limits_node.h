#pragma once

#include <set>
#include <string>
#include <vector>

#include <yaml-cpp/yaml.h>

namespace weld_profiler
{
/// A map of a table of limits that knows where it stands, so that each error names file, key, value and remedy.
class LimitsNode
{
public:
  /// @param place  `FILE: ` or `FILE: entries[3].`
  /// @throws ConfigError if the node is no map.
  LimitsNode(const YAML::Node& node, std::string place);

  bool has(const std::string& key) const;

  /// @throws ConfigError naming key and remedy if it is missing, of the wrong type or not in [low, high].
  double number(const std::string& key, double low, double high) const;
  std::string text(const std::string& key) const;
  bool flag(const std::string& key) const;

  /// The raw node. @throws ConfigError if it is missing.
  YAML::Node child(const std::string& key, const std::string& remedy) const;

  /// @throws ConfigError naming the first key that is not known.
  void refuseUnknown(const std::set<std::string>& known) const;

  /// `FILE: entries[3].KEY`
  std::string nameOf(const std::string& key) const { return place_ + key; }

private:
  YAML::Node node_;
  std::string place_;
};
}  // namespace weld_profiler
