#pragma once

#include <set>
#include <string>

#include <yaml-cpp/yaml.h>

#include "weld_profiler/core/yaml_fields.h"

namespace weld_profiler
{
/// The file behind `--params`: YAML in either of two forms.
///  - Sections named after the nodelets (`stripe_centre:`, `triangulation:`): each stage reads its own, the rest of the
///    known sections is left to others. One file serves every command and a launch file.
///  - A flat map: the parameters of the stages that ask, without section.
class ParamsFile
{
public:
  /// Sets nothing: every parameter keeps its default.
  ParamsFile() = default;

  /// @param path  empty = as ParamsFile(). @throws InputError (cannot be read), ConfigError (not YAML, unknown
  /// section).
  explicit ParamsFile(const std::string& path);

  /// Reads the fields of the parameter structs that make up one nodelet's section.
  /// @throws ConfigError naming file, key and type; in a section also for a key that no struct has.
  template <class... Params>
  void load(const std::string& nodelet, Params&... params)
  {
    YamlFields fields(sectioned_ ? section(nodelet) : root_, sectioned_ ? path_ + ": " + nodelet : path_);
    (params.visit(fields), ...);
    if (sectioned_)
      fields.refuseUnknown();
    NameCollector names{ &known_ };
    (params.visit(names), ...);
  }

  /// Call after the last load(): refuses keys of a flat file that no stage asked for. @throws ConfigError.
  void refuseUnknown() const;

private:
  struct NameCollector
  {
    std::set<std::string>* names;
    template <class T>
    void operator()(const std::string& name, T& /*value*/)
    {
      names->insert(name);
    }
  };

  YAML::Node section(const std::string& nodelet) const;

  std::string path_;
  YAML::Node root_;
  bool sectioned_ = false;
  std::set<std::string> known_;
};
}  // namespace weld_profiler
