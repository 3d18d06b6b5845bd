#pragma once

#include <string>
#include <vector>

namespace weld_profiler
{
/// The fields of a line of CSV without quotes.
inline std::vector<std::string> csvFields(const std::string& line)
{
  std::vector<std::string> fields(1);
  for (const char letter : line)
  {
    if (letter == ',')
      fields.emplace_back();
    else
      fields.back() += letter;
  }
  return fields;
}
}  // namespace weld_profiler
