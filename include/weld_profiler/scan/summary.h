#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "weld_profiler/core/balance.h"

namespace weld_profiler
{
/// A JSON object whose keys stay in the order they were added: the same calls give the same bytes.
class JsonObject
{
public:
  JsonObject& add(const std::string& key, const std::string& value);
  JsonObject& add(const std::string& key, const char* value) { return add(key, std::string(value)); }
  JsonObject& add(const std::string& key, double value);  ///< NaN and infinity become null
  JsonObject& add(const std::string& key, std::uint64_t value);
  JsonObject& add(const std::string& key, int value);
  JsonObject& add(const std::string& key, bool value);
  JsonObject& add(const std::string& key, const std::map<std::string, std::uint64_t>& counts);
  JsonObject& add(const std::string& key, const JsonObject& object);
  JsonObject& add(const std::string& key, const std::vector<std::string>& texts);
  JsonObject& add(const std::string& key, const std::vector<JsonObject>& objects);
  JsonObject& add(const std::string& key, const std::vector<double>& numbers);  ///< NaN and infinity become null

  /// @param indent  blanks before each line but the first. No line end after the closing brace.
  std::string text(int indent = 0) const;

private:
  struct Entry
  {
    std::string key;
    std::string json;             ///< of a plain value
    std::vector<Entry> children;  ///< of an object
    bool is_object = false;
  };
  static std::string text(const std::vector<Entry>& entries, int indent);
  JsonObject& addRaw(const std::string& key, const std::string& json);

  std::vector<Entry> entries_;
};

/// `frames_in rows no_stripe skipped`, `unplaced` and `dropped` as {reason: count}: the balance of Counting. Add what
/// else there is to say, then write text().
JsonObject summary(const FrameBalance& balance);

/// Writes summary text and a line end, whole or not at all. @throws InputError naming path and cause.
void writeSummary(const JsonObject& summary, const std::string& path);
}  // namespace weld_profiler
