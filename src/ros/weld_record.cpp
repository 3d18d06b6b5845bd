#include "weld_profiler/ros/weld_record.h"

#include <cmath>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <limits>
#include <locale>
#include <sstream>

#include <yaml-cpp/yaml.h>

#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
namespace
{
constexpr std::int64_t kNanoseconds = 1000000000;
constexpr double kDay = 86400.0;  // [s]

JsonObject json(const Quantity& quantity)
{
  JsonObject object;
  return object.add("value", quantity.value).add("sigma", quantity.sigma);
}

std::time_t seconds(const Scan& scan)
{
  return scan.rows.empty() ? 0 : static_cast<std::time_t>(scan.rows.front().stamp / kNanoseconds);
}

std::string isoDate(std::time_t time)
{
  std::tm parts{};
  gmtime_r(&time, &parts);
  char text[32];
  std::strftime(text, sizeof(text), "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text;
}

/// Days from a calibration's date (2024-05-01 or with a time behind it) to the scan; NaN = not dated.
double ageInDays(const std::string& date, const Scan& scan)
{
  std::tm parts{};
  if (std::sscanf(date.c_str(), "%d-%d-%d", &parts.tm_year, &parts.tm_mon, &parts.tm_mday) != 3)
    return std::numeric_limits<double>::quiet_NaN();
  parts.tm_year -= 1900;
  parts.tm_mon -= 1;
  return std::difftime(seconds(scan), timegm(&parts)) / kDay;
}

/// Collects parameters for weld.json.
struct ToJson
{
  JsonObject& object;
  void operator()(const std::string& name, const std::string& value) { object.add(name, value); }
  void operator()(const std::string& name, double value) { object.add(name, value); }
  void operator()(const std::string& name, int value) { object.add(name, value); }
  void operator()(const std::string& name, bool value) { object.add(name, value); }
};

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

JsonObject statisticsOf(const WeldResult& result)
{
  JsonObject all;
  for (const SectionStatistics& one : result.statistics)
  {
    JsonObject object;
    object.add("count", one.count)
        .add("mean", one.mean.value)
        .add("mean_sigma", one.mean.sigma)
        .add("deviation", one.deviation)
        .add("least", one.least)
        .add("largest", one.largest);
    all.add(one.name, object);
  }
  return all;
}

JsonObject verdictOf(const WeldEvaluation& evaluation, const WeldSettings& settings)
{
  const WeldVerdict& verdict = evaluation.verdict;
  JsonObject levels;
  for (const QualityLevel level : kQualityLevels)
    levels.add(name(level), name(verdict.levels[static_cast<std::size_t>(level)]));
  JsonObject object;
  object.add("overall", verdict.verdict)
      .add("unverified", verdict.unverified)
      .add("asked", settings.judging.level)
      .add("asked_decision", name(verdict.asked))
      .add("levels", levels)
      .add("notes", verdict.notes)
      .add("limits", settings.judging.limits_file.empty() ? "ISO 5817, built in" : settings.judging.limits_file)
      .add("thickness", settings.judging.thickness.value_or(std::numeric_limits<double>::quiet_NaN()));
  return object;
}

std::vector<JsonObject> othersOf(const WeldResult& result)
{
  std::vector<JsonObject> all;
  for (const OtherBead& bead : result.other_beads)
  {
    JsonObject object;
    object.add("x", bead.x).add("y_from", bead.y_from).add("y_to", bead.y_to).add("width", bead.width);
    object.add("height", bead.height);
    all.push_back(object);
  }
  return all;
}

JsonObject calibrationOf(const CalibrationRecord& calibration, const Scan& scan)
{
  JsonObject object;
  return object.add("file", calibration.file)
      .add("hash", calibration.hash)
      .add("date", calibration.date)
      .add("age_days", ageInDays(calibration.date, scan));
}
}  // namespace

CalibrationRecord calibrationRecord(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  std::ostringstream content;
  content << file.rdbuf();
  if (!file)
    throw InputError("cannot read " + path + ", give a calibration file");
  // FNV-1a: G. Fowler, L. C. Noll, K.-P. Vo, D. Eastlake, "The FNV Non-Cryptographic Hash Algorithm".
  std::uint64_t hash = 14695981039346656037ULL;
  for (const char c : content.str())
    hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  char digits[17];
  std::snprintf(digits, sizeof(digits), "%016llx", static_cast<unsigned long long>(hash));
  CalibrationRecord record{ path, digits, "" };
  try
  {
    const YAML::Node root = YAML::Load(content.str());
    if (root.IsMap() && root["date"] && root["date"].IsScalar())
      record.date = root["date"].Scalar();
  }
  catch (const YAML::Exception&)
  {
    record.date.clear();  // whoever loads the calibration says what is wrong with it
  }
  return record;
}

std::string settingsText(const WeldSettings& settings)
{
  WeldSettings copy = settings;
  std::ostringstream out;
  out.imbue(std::locale::classic());
  copy.visit(ToYaml{ out });
  return out.str();
}

JsonObject weldRecord(const Scan& scan, const WeldEvaluation& evaluation, const WeldSettings& settings,
                      const WeldRecordInfo& info)
{
  const WeldResult& result = evaluation.result;
  JsonObject scores;
  for (const KindScore& score : result.scores)
    scores.add(name(score.kind), score.score);
  JsonObject used;
  WeldSettings copy = settings;
  copy.visit(ToJson{ used });
  JsonObject object;
  object.add("id", info.weld_id)
      .add("date", isoDate(seconds(scan)))
      .add("frame_id", scan.frame_id)
      .add("kind", name(result.kind))
      .add("reason", result.reason)
      .add("scores", scores)
      .add("sections", static_cast<std::uint64_t>(result.sections.size()))
      .add("measured_share", result.measured_share)
      .add("length", json(result.length))
      .add("volume", json(result.volume))
      .add("removal_volume", json(result.removal_volume))
      .add("ripple_pitch", json(result.ripple_pitch))
      .add("ripple_height", json(result.ripple_height))
      .add("statistics", statisticsOf(result))
      .add("other_beads", othersOf(result))
      .add("verdict", verdictOf(evaluation, settings))
      .add("settings", used)
      .add("calibration", calibrationOf(info.calibration, scan));
  return object;
}
}  // namespace weld_profiler
