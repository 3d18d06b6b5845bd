#include "weld_profiler/ros/origin.h"

#include <algorithm>

#include "weld_profiler/core/checksum.h"
#include "weld_profiler/core/errors.h"
#include "weld_profiler/core/utf8.h"

namespace weld_profiler
{
namespace
{
constexpr std::size_t kLongestId = 100;

/// A text as one field: what would end it is replaced.
std::string field(std::string text)
{
  for (char& letter : text)
    letter = letter == ',' ? ';' : letter == '"' ? '\'' : letter;
  return text;
}
}  // namespace

std::string software()
{
  return "weld_profiler " WELD_PROFILER_VERSION;
}

std::vector<std::string> Origin::comments() const
{
  std::vector<std::string> lines = { software(), "weld " + weld_id, "frame " + frame_id,
                                     "calibration " + calibration_hash, "settings " + checksum(settings) };
  std::istringstream all(settings);
  for (std::string line; std::getline(all, line);)
    lines.push_back("setting " + line);
  return lines;
}

std::string Origin::inCsv(const std::string& csv) const
{
  const std::string columns = "," + field(weld_id) + "," + calibration_hash + "," + checksum(settings);
  std::istringstream lines(csv);
  std::string out;
  for (std::string line; std::getline(lines, line);)
    out += line + (out.empty() ? ",weld_id,calibration_hash,settings_hash" : columns) + "\n";
  return out;
}

void requireWeldId(const std::string& id)
{
  if (std::any_of(id.begin(), id.end(), [](unsigned char letter) { return letter < 32 || letter == 127; }))
    throw ConfigError("the weld's id holds a line break, a tab or another control character, must be one line of text");
  if (!isUtf8(id))
    throw ConfigError("the weld's id is no UTF-8 text, must be: the files that bear it are");
  if (id.size() > kLongestId)
    throw ConfigError("the weld's id has " + std::to_string(id.size()) + " characters, must have at most " +
                      std::to_string(kLongestId));
}
}  // namespace weld_profiler
