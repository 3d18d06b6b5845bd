#include "weld_profiler/ros/weld_record.h"

#include <cmath>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <limits>
#include <locale>
#include <sstream>

#include <yaml-cpp/yaml.h>

#include "weld_profiler/core/checksum.h"
#include "weld_profiler/core/errors.h"
#include "weld_profiler/ros/origin.h"

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

JsonObject unseenOf(const UnseenPores& unseen)
{
  JsonObject object;
  return object.add("round", unseen.round).add("shallow", unseen.shallow);
}

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

/// The limits of the height along the weld, as far as they follow the width alone.
JsonObject heightLimitsOf(const WeldEvaluation& evaluation, const VerdictParams& judging)
{
  JsonObject limits;
  if (!evaluation.height_limits)
    return limits;
  LimitDimensions plate;
  plate.t = judging.thickness;
  plate.s = judging.nominal_thickness ? judging.nominal_thickness : judging.thickness;
  for (const QualityLevel level : kQualityLevels)
  {
    const LevelLimit& limit = evaluation.height_limits->at(level);
    const bool limited = limit.rule == LevelLimit::Rule::Limit || limit.rule == LevelLimit::Rule::Short;
    LevelLimit constant = limit;
    constant.factor = limit.of == 'b' ? 0.0 : limit.factor, constant.of = limit.of == 'b' ? '\0' : limit.of;
    const double base = limited ? evaluate(constant, plate).value : std::numeric_limits<double>::quiet_NaN();
    if (!std::isfinite(base))
      continue;
    JsonObject one;
    one.add("base", base).add("factor", limit.of == 'b' ? limit.factor : 0.0).add("cap", limit.cap);
    limits.add(name(level), one);
  }
  return limits;
}

JsonObject verdictOf(const WeldEvaluation& evaluation, const WeldSettings& settings)
{
  const WeldVerdict& verdict = evaluation.verdict;
  JsonObject levels;
  for (const QualityLevel level : kQualityLevels)
    levels.add(name(level), name(verdict.levels[static_cast<std::size_t>(level)]));
  std::map<std::string, std::uint64_t> waiting;
  for (const auto& [what, count] : verdict.waiting.for_what)
    waiting[what] = static_cast<std::uint64_t>(count);
  JsonObject object;
  object.add("overall", verdict.verdict)
      .add("unverified", verdict.unverified)
      .add("asked", settings.judging.level)
      .add("asked_decision", name(verdict.asked))
      .add("levels", levels)
      .add("waits_for", verdict.waits_for)
      .add("sections_waiting", waiting)
      .add("lacks_thickness", verdict.lacks_thickness)
      .add("notes", verdict.notes)
      .add("limits", settings.judging.limits_file.empty() ? "ISO 5817, built in" : settings.judging.limits_file)
      .add("height_limits", heightLimitsOf(evaluation, settings.judging))
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
  CalibrationRecord record{ path, checksum(content.str()), "" };
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
  return yamlOf(settings);
}

JsonObject weldRecord(const Scan& scan, const WeldEvaluation& evaluation, const WeldSettings& settings,
                      const WeldRecordInfo& info)
{
  const WeldResult& result = evaluation.result;
  JsonObject scores;
  for (const KindScore& score : result.scores)
    scores.add(name(score.kind), score.score);
  JsonObject object;
  object.add("software", software())
      .add("id", info.weld_id)
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
      .add("volume_length", result.volume_length)
      .add("grinding_passes", static_cast<std::uint64_t>(evaluation.plan.passes.size()))
      .add("grinding_reason", evaluation.plan.reason)
      .add("ripple_pitch", json(result.ripple_pitch))
      .add("ripple_height", json(result.ripple_height))
      .add("runs_out", result.runs_out)
      .add("unseen_pores", unseenOf(result.unseen_pores))
      .add("statistics", statisticsOf(result))
      .add("other_beads", othersOf(result))
      .add("verdict", verdictOf(evaluation, settings))
      .add("settings", jsonOf(settings))
      .add("settings_hash", checksum(settingsText(settings)))
      .add("calibration", calibrationOf(info.calibration, scan));
  return object;
}
}  // namespace weld_profiler
