#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "limits_iso5817.h"
#include "limits_node.h"
#include "limits_rules.h"
#include "weld_profiler/core/errors.h"
#include "weld_profiler/weld/limits.h"

namespace weld_profiler
{
namespace
{
constexpr double kMetresPerMm = 1e-3;
constexpr double kRadPerDeg = 0.017453292519943295;
constexpr double kMostMm = 1000.0;
constexpr double kMostFactor = 100.0;

bool readVerified(const LimitsNode& node)
{
  const std::string source = node.text("source");
  requireOneOf(node.nameOf("source"), source, std::array<std::string, 2>{ { "read", "unverified" } });
  return source == "read";
}

Imperfection readImperfection(const LimitsNode& node)
{
  const int number = static_cast<int>(node.number("iso", 0.0, 99999.0));
  std::string list;
  for (const Imperfection candidate : imperfections())
  {
    if (isoNumber(candidate) == number)
      return candidate;
    list += (list.empty() ? "" : ", ") + std::to_string(isoNumber(candidate));
  }
  throw ConfigError(node.nameOf("iso") + " is " + std::to_string(number) + ", must be one of: " + list +
                    " (what is measured)");
}

std::vector<WeldKind> readKinds(const LimitsNode& node)
{
  const YAML::Node list = node.child("kinds", "a list of butt, fillet, bead_on_plate");
  if (!list.IsSequence() || list.size() == 0)
    throw ConfigError(node.nameOf("kinds") + " is " + (list.IsSequence() ? "empty" : "no list") +
                      ", must be a list of butt, fillet, bead_on_plate");
  std::vector<WeldKind> kinds;
  for (const YAML::Node& item : list)
  {
    const std::string text = item.IsScalar() ? item.Scalar() : "(a list)";
    requireOneOf(node.nameOf("kinds"), text, std::array<std::string, 3>{ { "butt", "fillet", "bead_on_plate" } });
    for (const WeldKind kind : { WeldKind::Butt, WeldKind::Fillet, WeldKind::BeadOnPlate })
    {
      if (text == name(kind))
        kinds.push_back(kind);
    }
  }
  return kinds;
}

void readThickness(const LimitsNode& node, LimitEntry& entry)
{
  const auto metres = [&node](const char* key, double fallback)
  { return node.has(key) ? kMetresPerMm * node.number(key, 0.0, kMostMm) : fallback; };
  entry.any_thickness = !node.has("above_mm") && !node.has("from_mm") && !node.has("to_mm");
  entry.above = metres("above_mm", entry.above);
  entry.from = metres("from_mm", entry.from);
  entry.to = metres("to_mm", entry.to);
  if (std::max(entry.above, entry.from) > entry.to)
    throw ConfigError(node.nameOf("to_mm") + " is " + node.text("to_mm") +
                      ", must not be less than from_mm or above_mm: no plate is in the range");
}

LevelLimit readLength(const LimitsNode& node)
{
  node.refuseUnknown({ "base_mm", "factor", "of", "cap_mm", "short" });
  LevelLimit limit;
  limit.rule = node.flag("short") ? LevelLimit::Rule::Short : LevelLimit::Rule::Limit;
  if (node.has("base_mm"))
    limit.base = kMetresPerMm * node.number("base_mm", 0.0, kMostMm);
  if (node.has("cap_mm"))
    limit.cap = kMetresPerMm * node.number("cap_mm", 1e-3, kMostMm);
  if (node.has("factor") || node.has("of"))
  {
    limit.factor = node.number("factor", 0.0, kMostFactor);
    const std::string of = node.text("of");
    requireOneOf(node.nameOf("of"), of, std::array<std::string, 4>{ { "a", "b", "s", "t" } });
    limit.of = of.front();
  }
  else
  {
    node.child("base_mm", "`base_mm`, or `factor` and `of`");
  }
  return limit;
}

LevelLimit readLevel(const LimitsNode& entry, const char* key, bool angle)
{
  const YAML::Node node = entry.child(key, angle ? "`base_deg`" : "a limit, not_permitted or permitted");
  LevelLimit limit;
  if (node.IsScalar())
  {
    requireOneOf(entry.nameOf(key), node.Scalar(), std::array<std::string, 2>{ { "not_permitted", "permitted" } });
    if (angle && node.Scalar() != "permitted")
      throw ConfigError(entry.nameOf(key) + " is 'not_permitted', must be an angle {base_deg: ...} or permitted");
    limit.rule = node.Scalar() == "permitted" ? LevelLimit::Rule::Permitted : LevelLimit::Rule::NotPermitted;
    return limit;
  }
  const LimitsNode map(node, entry.nameOf(key) + ".");
  if (!angle)
    return readLength(map);
  map.refuseUnknown({ "base_deg" });
  limit.rule = LevelLimit::Rule::Limit;
  limit.base = kRadPerDeg * map.number("base_deg", 0.0, 180.0);
  return limit;
}

LimitEntry readEntry(const LimitsNode& node)
{
  node.refuseUnknown({ "iso", "kinds", "above_mm", "from_mm", "to_mm", "edition", "source", "B", "C", "D" });
  LimitEntry entry;
  entry.imperfection = readImperfection(node);
  entry.least = entry.imperfection == Imperfection::ToeAngle;
  entry.kinds = readKinds(node);
  readThickness(node, entry);
  entry.edition = node.text("edition");
  entry.verified = readVerified(node);
  for (const QualityLevel level : kQualityLevels)
    entry.levels[static_cast<std::size_t>(level)] = readLevel(node, name(level), entry.least);
  return entry;
}

ShortRule readShortRule(const LimitsNode& node)
{
  node.refuseUnknown({ "length_mm", "per_mm", "share", "edition", "source" });
  ShortRule rule;
  rule.per = kMetresPerMm * node.number("per_mm", 1.0, kMostMm);
  rule.length = kMetresPerMm * node.number("length_mm", 0.0, rule.per / kMetresPerMm);
  rule.share = node.number("share", 0.0, 1.0);
  rule.edition = node.text("edition");
  rule.verified = readVerified(node);
  return rule;
}

YAML::Node parseYaml(const std::string& text, const std::string& origin)
{
  try
  {
    return YAML::Load(text);
  }
  catch (const YAML::Exception& error)
  {
    throw ConfigError(origin + ": line " + std::to_string(error.mark.line + 1) + ": malformed YAML (" + error.msg +
                      "), correct that line");
  }
}
}  // namespace

/// Fills a Limits from YAML.
class LimitsReader
{
public:
  static Limits read(const LimitsNode& root, const std::string& origin)
  {
    root.refuseUnknown({ "version", "standard", "least_thickness_mm", "short", "entries" });
    root.number("version", 1.0, 1.0);
    Limits limits;
    limits.origin_ = origin;
    limits.standard_ = root.text("standard");
    limits.least_thickness_ = kMetresPerMm * root.number("least_thickness_mm", 0.0, kMostMm);
    limits.short_rule_ = readShortRule(LimitsNode(root.child("short", "`short:`"), root.nameOf("short.")));
    const YAML::Node entries = root.child("entries", "a list of limits");
    if (!entries.IsSequence())
      throw ConfigError(root.nameOf("entries") + " is no list, must be a list of limits");
    if (entries.size() == 0)
      throw ConfigError(root.nameOf("entries") + " is empty, must have one limit or more");
    for (std::size_t i = 0; i < entries.size(); ++i)
      limits.entries_.push_back(readEntry(LimitsNode(entries[i], root.nameOf("entries[" + std::to_string(i) + "]."))));
    requireConsistent(limits.entries_, origin);
    return limits;
  }
};

Limits Limits::parse(const std::string& text, const std::string& origin)
{
  return LimitsReader::read(LimitsNode(parseYaml(text, origin), origin + ": "), origin);
}

Limits Limits::load(const std::string& path)
{
  std::ostringstream content;
  std::ifstream stream(path, std::ios::binary);
  if (!stream || std::filesystem::is_directory(path) || !(content << stream.rdbuf() || stream.peek() == EOF))
    throw InputError("cannot read table of limits " + path + ": no such file or not readable, check the path");
  return parse(content.str(), path);
}

Limits Limits::shipped()
{
  return parse(kIso5817Table, "config/limits/iso5817.yaml");
}
}  // namespace weld_profiler
