#pragma once

#include <map>
#include <string>

#include <diagnostic_msgs/DiagnosticArray.h>

#include "support/collector.h"

namespace weld_profiler
{
/// What a nodelet last said on /diagnostics.
class DiagnosticsReader
{
public:
  /// @param nodelet  full name, such as /profiler/triangulation.
  explicit DiagnosticsReader(const std::string& nodelet) : name_(nodelet.substr(1)), collector_("/diagnostics") {}

  /// Its latest values; empty when it has said nothing.
  std::map<std::string, std::string> latest() const
  {
    std::map<std::string, std::string> values;
    for (const auto& array : collector_.all())
    {
      for (const auto& status : array->status)
      {
        if (status.name.find(name_) == std::string::npos)
          continue;
        values.clear();
        values["level"] = std::to_string(status.level);
        values["message"] = status.message;
        for (const auto& value : status.values)
          values[value.key] = value.value;
      }
    }
    return values;
  }

  /// A count, 0 when it was not said.
  std::uint64_t count(const std::string& key) const
  {
    const auto values = latest();
    const auto found = values.find(key);
    return found == values.end() ? 0 : std::stoull(found->second);
  }

private:
  std::string name_;
  Collector<diagnostic_msgs::DiagnosticArray> collector_;
};
}  // namespace weld_profiler
