#pragma once

#include <locale>
#include <sstream>
#include <string>
#include <vector>

#include "weld_profiler/scan/summary.h"

namespace weld_profiler
{
/// `weld_profiler 0.1.0`: what writes the files.
std::string software();

/// What a file can be traced to. It stands in each of them.
struct Origin
{
  std::string weld_id;   ///< as asked for; may be empty
  std::string frame_id;  ///< of the coordinates; empty = the file has none
  std::string calibration_hash;
  std::string settings;  ///< every parameter: lines of YAML

  /// For the head of a cloud or a mesh, one line each.
  std::vector<std::string> comments() const;

  /// CSV with the columns weld_id, calibration_hash and settings_hash behind its own. A comment line would not be the
  /// header that programs expect, and would be lost by the first spreadsheet that saves the file.
  std::string inCsv(const std::string& csv) const;
};

/// @throws ConfigError unless the id of a weld is one line of UTF-8, at most 100 bytes.
void requireWeldId(const std::string& id);

namespace detail
{
struct ToYaml
{
  std::ostringstream& out;
  template <class Value>
  void operator()(const std::string& name, const Value& value)
  {
    out << name << ": " << value << '\n';
  }
  void operator()(const std::string& name, bool value) { out << name << ": " << (value ? "true" : "false") << '\n'; }
  void operator()(const std::string& name, const std::string& value) { out << name << ": \"" << value << "\"\n"; }
};

struct ToJson
{
  JsonObject& object;
  template <class Value>
  void operator()(const std::string& name, const Value& value)
  {
    object.add(name, value);
  }
};
}  // namespace detail

/// The fields of a parameter struct as lines of YAML, in the C locale.
template <class Params>
std::string yamlOf(Params params)
{
  std::ostringstream out;
  out.imbue(std::locale::classic());
  params.visit(detail::ToYaml{ out });
  return out.str();
}

template <class Params>
JsonObject jsonOf(Params params)
{
  JsonObject object;
  params.visit(detail::ToJson{ object });
  return object;
}
}  // namespace weld_profiler
