#include "weld_profiler/scan/summary.h"

#include <cmath>
#include <cstdio>
#include <locale>
#include <sstream>

#include "weld_profiler/core/atomic_file.h"
#include "weld_profiler/core/utf8.h"

namespace weld_profiler
{
namespace
{
/// JSON is UTF-8 (RFC 8259): what is none, as in a path of another encoding, becomes U+FFFD.
std::string quoted(const std::string& value)
{
  std::string json = "\"";
  for (std::size_t at = 0; at < value.size();)
  {
    const std::size_t length = utf8Length(value, at);
    const char c = value[at];
    if (length == 0)
    {
      json += "\\ufffd";
    }
    else if (static_cast<unsigned char>(c) < 0x20)
    {
      char escape[8];
      std::snprintf(escape, sizeof(escape), "\\u%04x", static_cast<unsigned>(c));
      json += escape;
    }
    else
    {
      json += (c == '"' || c == '\\' ? "\\" : "") + value.substr(at, length);
    }
    at += length == 0 ? 1 : length;
  }
  return json + '"';
}

std::string number(double value)
{
  if (!std::isfinite(value))
    return "null";
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out.precision(12);
  out << value;
  return out.str();
}
}  // namespace

JsonObject& JsonObject::addRaw(const std::string& key, const std::string& json)
{
  entries_.push_back(Entry{ key, json, {}, false });
  return *this;
}

JsonObject& JsonObject::add(const std::string& key, const std::string& value)
{
  return addRaw(key, quoted(value));
}

JsonObject& JsonObject::add(const std::string& key, double value)
{
  return addRaw(key, number(value));
}

JsonObject& JsonObject::add(const std::string& key, const std::vector<double>& numbers)
{
  std::string json = "[";
  for (const double value : numbers)
    json += (json.size() > 1 ? ", " : "") + number(value);
  return addRaw(key, json + "]");
}

JsonObject& JsonObject::add(const std::string& key, std::uint64_t value)
{
  return addRaw(key, std::to_string(value));
}

JsonObject& JsonObject::add(const std::string& key, int value)
{
  return addRaw(key, std::to_string(value));
}

JsonObject& JsonObject::add(const std::string& key, bool value)
{
  return addRaw(key, value ? "true" : "false");
}

JsonObject& JsonObject::add(const std::string& key, const std::map<std::string, std::uint64_t>& counts)
{
  JsonObject object;
  for (const auto& count : counts)
    object.add(count.first, count.second);
  return add(key, object);
}

JsonObject& JsonObject::add(const std::string& key, const JsonObject& object)
{
  entries_.push_back(Entry{ key, "", object.entries_, true });
  return *this;
}

JsonObject& JsonObject::add(const std::string& key, const std::vector<std::string>& texts)
{
  std::string json;
  for (const std::string& text : texts)
    json += (json.empty() ? "" : ", ") + quoted(text);
  return addRaw(key, "[" + json + "]");
}

JsonObject& JsonObject::add(const std::string& key, const std::vector<JsonObject>& objects)
{
  constexpr int kIndent = 2;
  std::string json;
  for (const JsonObject& object : objects)
    json += (json.empty() ? "" : ", ") + object.text(kIndent);
  return addRaw(key, "[" + json + "]");
}

std::string JsonObject::text(int indent) const
{
  return text(entries_, indent);
}

std::string JsonObject::text(const std::vector<Entry>& entries, int indent)
{
  if (entries.empty())
    return "{}";
  const std::string margin(static_cast<std::size_t>(indent), ' ');
  std::string json;
  for (const Entry& entry : entries)
    json += (json.empty() ? "{\n" : ",\n") + margin + "  " + quoted(entry.key) + ": " +
            (entry.is_object ? text(entry.children, indent + 2) : entry.json);
  return json + "\n" + margin + "}";
}

JsonObject summary(const FrameBalance& balance)
{
  JsonObject object;
  object.add("frames_in", balance.frames_in)
      .add("rows", balance.rows)
      .add("no_stripe", balance.no_stripe)
      .add("skipped", balance.skipped)
      .add("unplaced", balance.unplaced)
      .add("dropped", balance.dropped);
  return object;
}

void writeSummary(const JsonObject& summary, const std::string& path)
{
  writeWholeFile(path, summary.text() + "\n");
}
}  // namespace weld_profiler
