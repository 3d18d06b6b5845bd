#include "weld/tables.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>

#include "weld/found_tables.h"
#include "weld/spread.h"

namespace weld_profiler
{
namespace weld_accuracy
{
namespace
{
using comparison::Field;
using comparison::Report;
using comparison::Row;
using Welds = std::vector<WeldCase>;
constexpr std::size_t kWorst = 6;

struct Class
{
  const char* name;
  Chosen chosen;
};

Chosen highOf(const std::string& kind)
{
  return [kind](const WeldCase& weld, const SectionCase& section)
  { return weld.kind == kind && section.stature == Stature::High; };
}

std::vector<Class> classes()
{
  return { { "butt", highOf("butt") },
           { "fillet", highOf("fillet") },
           { "fillet, h < 0.5 mm", [](const WeldCase& /*weld*/, const SectionCase& section)
             { return section.stature == Stature::LowFillet; } },
           { "bead on plate", highOf("bead_on_plate") },
           { "low", [](const WeldCase& weld, const SectionCase& section) { return !counts(weld, section); } } };
}

void reportSizes(const Welds& welds, Report& report)
{
  report.table("sizes", "errors of the sections by kind of weld; sigma = deviation of error over the told sigma");
  for (const Class& sections : classes())
  {
    for (const Group& sizes : groups())
    {
      const Spread spread = spreadOf(samplesOf(welds, sizes, sections.chosen), sizes.folded);
      if (spread.count == 0)
        continue;
      report.row({ { "size", std::string(sections.name) },
                   { "quantity", std::string(sizes.name) },
                   { "unit", sizes.unit },
                   { "n", static_cast<double>(spread.count), 0 },
                   { "known %", 100.0 * spread.known, 1 },
                   { "median", spread.median, 4 },
                   { "95 %", spread.within95, 4 },
                   { "largest", spread.largest, 4 },
                   { "sigma", spread.plain, 2 },
                   { "robust", spread.robust, 2 } });
    }
  }
}

std::string listed(const std::vector<Worst>& worst)
{
  std::string text;
  for (const Worst& weld : worst)
  {
    char buffer[60];
    std::snprintf(buffer, sizeof buffer, "%s%llu (%.3g)", text.empty() ? "" : ", ",
                  static_cast<unsigned long long>(weld.seed), weld.value);
    text += buffer;
  }
  return text;
}

/// The welds whose value is largest.
void reportWorst(const char* what, const Welds& welds, const std::function<double(const WeldCase&)>& value,
                 Report& report)
{
  std::vector<Worst> all;
  for (const WeldCase& weld : welds)
    all.push_back({ weld.seed, value(weld) });
  const std::vector<Worst> worst = worstFirst(std::move(all), kWorst);
  const std::string list = listed(worst);
  std::printf("%-44s %s\n", what, list.c_str());
  report.row({ { "what", what }, { "seeds", list } }, Report::Silent);
}

double errorOf(const WeldCase& weld, const Group& sizes)
{
  return spreadOf(samplesOf({ weld }, sizes, counts), sizes.folded).within95;
}

double missing(const WeldCase& weld)
{
  const double inside = weld.shares.inside[1] + weld.shares.inside[2];
  const double found = weld.shares.inside_found[1] + weld.shares.inside_found[2];
  return inside > 0.0 && found < inside ? 100.0 * (1.0 - found / inside) : kNaN;
}

double wrongVerdicts(const WeldCase& weld)
{
  double wrong = 0.0;
  for (const SectionCase& section : weld.sections)
  {
    const bool decided = section.hasBead() && !section.verdict.empty() && section.verdict != "undecided";
    wrong += decided && section.verdict != section.true_verdict ? 1.0 : 0.0;
  }
  return wrong > 0.0 ? wrong : kNaN;
}

void reportWorstWelds(const Welds& welds, Report& report)
{
  report.table("worst", "the worst welds: seed (value)");
  for (const char* name : { "width", "reinforcement", "undercut", "misalignment", "toe angle" })
  {
    const Group& sizes = group(name);
    reportWorst((std::string(name) + ", 95 % of |error| [" + sizes.unit + "]").c_str(), welds,
                [&](const WeldCase& weld) { return errorOf(weld, sizes); }, report);
  }
  reportWorst(
      "volume, error over allowance", welds,
      [](const WeldCase& weld) { return overAllowance(weld, weld.volumes.measured, weld.volumes.truth); }, report);
  reportWorst(
      "removal map, error over allowance", welds,
      [](const WeldCase& weld) { return overAllowance(weld, weld.volumes.removal, weld.volumes.true_removal); },
      report);
  reportWorst("sections not measured [%]", welds, missing, report);
  reportWorst("wrong verdicts [sections]", welds, wrongVerdicts, report);
  for (const std::size_t label : { 1, 2, 3 })
    reportWorst(
        label == 1 ? "1 - IoU of base" : (label == 2 ? "1 - IoU of bead" : "1 - IoU of undercut"), welds,
        [label](const WeldCase& weld) { return 1.0 - intersectionOverUnion(weld.labels, label); }, report);
  reportWorst(
      "measure() of 200 rows [ms]", welds, [](const WeldCase& weld) { return weld.times.measure * 200.0 / weld.rows; },
      report);
}

void reportVerdicts(const Welds& welds, Report& report)
{
  report.table("verdicts", "sections by true verdict (rows) and by what was said");
  std::map<std::string, std::map<std::string, double>> counted;
  for (const WeldCase& weld : welds)
  {
    for (const SectionCase& section : weld.sections)
    {
      if (section.hasBead())
        counted[section.true_verdict][section.verdict.empty() ? "none" : section.verdict] += 1.0;
    }
  }
  for (const char* truth : { "B", "C", "D", "fail" })
  {
    Row row = { { "truth", truth } };
    for (const char* said : { "B", "C", "D", "fail", "undecided", "none" })
      row.push_back({ said, counted[truth][said], 0 });
    report.row(row);
  }
}

void reportWelds(const Welds& welds, Report& report)
{
  report.table("welds", "weld by weld");
  for (const WeldCase& weld : welds)
  {
    Row row = { { "seed", static_cast<double>(weld.seed), 0 },
                { "kind", weld.kind },
                { "measured_kind", weld.measured_kind },
                { "width_mm", 1e3 * weld.width, 3 },
                { "reinforcement_mm", 1e3 * weld.reinforcement, 3 },
                { "missing_percent", missing(weld), 2 } };
    for (const char* name : { "width", "reinforcement", "undercut", "misalignment", "toe angle" })
      row.push_back({ std::string(name) + "_95", errorOf(weld, group(name)), 4 });
    row.push_back({ "volume_over_allowance", overAllowance(weld, weld.volumes.measured, weld.volumes.truth), 3 });
    row.push_back(
        { "removal_over_allowance", overAllowance(weld, weld.volumes.removal, weld.volumes.true_removal), 3 });
    row.push_back({ "iou_base", intersectionOverUnion(weld.labels, 1), 4 });
    row.push_back({ "iou_bead", intersectionOverUnion(weld.labels, 2), 4 });
    row.push_back({ "measure_ms", weld.times.measure, 1 });
    report.row(row, Report::Silent);
  }
}
}  // namespace

void reportDetails(const Welds& welds, Report& report)
{
  reportSizes(welds, report);
  reportShares(welds, report);
  reportSpots(welds, report);
  reportVerdicts(welds, report);
  reportWorstWelds(welds, report);
  reportWelds(welds, report);
}

void reportBars(const std::vector<Bar>& bars, Report& report)
{
  report.table("bars", "what is asked");
  for (const Bar& bar : bars)
    report.row({ { "what", bar.what },
                 { "measured", bar.measured, 4 },
                 { "asked", bar.limits() },
                 { "unit", bar.unit },
                 { "verdict", bar.met() ? "met" : "MISSED" },
                 { "detail", bar.detail } },
               Report::Silent);
}
}  // namespace weld_accuracy
}  // namespace weld_profiler
