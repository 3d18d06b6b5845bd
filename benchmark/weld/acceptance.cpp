#include "weld/acceptance.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "weld/spread.h"

namespace weld_profiler
{
namespace weld_accuracy
{
namespace
{
using Welds = std::vector<WeldCase>;
constexpr double kLeastHonest = 0.8, kMostHonest = 1.3;
constexpr double kWideSigma = 0.25e-3;
constexpr double kRises = 3.0;        // sigmas by which a bead stands out
constexpr double kWideBead = 6e-3;    // labels are judged from this width on [m]
constexpr double kRowsOfBar = 200.0;  // the scan that the bar of speed is for
constexpr int kNearlyAsManyRows = 190;

std::string format(const char* how, double a, double b = 0.0)
{
  char text[120];
  std::snprintf(text, sizeof text, how, a, b);
  return text;
}

Bar atMost(const std::string& what, double measured, double most, const char* unit)
{
  return Bar{ what, unit, measured, kNaN, most, "" };
}

Bar atLeast(const std::string& what, double measured, double least, const char* unit)
{
  return Bar{ what, unit, measured, least, kNaN, "" };
}

void addErrors(const Welds& welds, const std::string& name, const std::array<double, 2>& most, std::vector<Bar>& bars)
{
  const Group& sizes = group(name);
  const Chosen chosen = [&](const WeldCase& weld, const SectionCase& section)
  { return counts(weld, section) && (name != "misalignment" || weld.kind == "butt"); };
  const Spread spread = spreadOf(samplesOf(welds, sizes, chosen), sizes.folded);
  if (std::isfinite(most[0]))
    bars.push_back(atMost(name + ", |median error|", std::abs(spread.median), most[0], sizes.unit));
  bars.push_back(atMost(name + ", 95 % of |error|", spread.within95, most[1], sizes.unit));
  bars.back().detail = format("%.0f values, the largest error %.3g", static_cast<double>(spread.count), spread.largest);
}

/// Welds most of whose sections the bars hold for.
bool mostlyCounts(const WeldCase& weld)
{
  const Shares& shares = weld.shares;
  return 2 * (shares.inside[1] + shares.inside[2]) > shares.inside[0] + shares.inside[1] + shares.inside[2];
}

template <class Measured, class Truth>
void addIntegral(const Welds& welds, const char* name, Measured measured, Truth truth, std::vector<Bar>& bars)
{
  double beyond = 0.0, all = 0.0;
  std::vector<double> ratios;
  for (const WeldCase& weld : welds)
  {
    const double ratio = overAllowance(weld, measured(weld.volumes), truth(weld.volumes));
    if (!mostlyCounts(weld) || !std::isfinite(ratio))
      continue;
    ratios.push_back(ratio);
    all += 1.0, beyond += ratio > 1.0 ? 1.0 : 0.0;
  }
  bars.push_back(atMost(std::string(name) + ": welds beyond max(1 %, 5 um b l)", beyond, 0.0, "welds"));
  bars.back().detail = format("of %.0f; median of error over allowance %.2f", all, quantile(ratios, 0.5)) +
                       format(", 95 %% %.2f", quantile(ratios, 0.95));
}

double share(double part, double whole)
{
  return whole > 0.0 ? 100.0 * part / whole : kNaN;
}

void addMeasuredShare(const Welds& welds, std::vector<Bar>& bars)
{
  double inside = 0.0, found = 0.0, toes = 0.0, toes_found = 0.0;
  for (const WeldCase& weld : welds)
  {
    for (std::size_t i = 1; i < 3; ++i)
    {
      inside += weld.shares.inside[i], found += weld.shares.inside_found[i];
      toes += weld.shares.toes[i], toes_found += weld.shares.toes_found[i];
    }
  }
  bars.push_back(atLeast("measured share", share(found, inside), 97.0, "%"));
  bars.back().detail = format("of %.0f sections; of all with both toes in view %.2f", inside, share(toes_found, toes));
}

void addLow(const Welds& welds, std::vector<Bar>& bars)
{
  const Chosen low = [](const WeldCase& weld, const SectionCase& section) { return !counts(weld, section); };
  const Spread width = spreadOf(samplesOf(welds, group("width"), low), false);
  bars.push_back(Bar{ "low sections: width error / sigma, deviation", "", width.plain, kLeastHonest, kMostHonest,
                      format("robust %.2f; %.0f sections", width.robust, static_cast<double>(width.honest_count)) });
  double wide = 0.0, flat = 0.0, beads = 0.0;
  for (const WeldCase& weld : welds)
  {
    for (const SectionCase& section : weld.sections)
    {
      if (!section.hasBead())
        continue;
      const Deviation& height = section.sizes[Reinforcement];
      wide += section.sizes[Width].sigma > kWideSigma ? 1.0 : 0.0;
      if (weld.kind == "fillet")
        continue;
      beads += 1.0, flat += height.value < kRises * height.sigma || height.truth < kRises * height.sigma ? 1.0 : 0.0;
    }
  }
  bars.push_back(atMost("widths told with a sigma above 0.25 mm", wide, 0.0, "sections"));
  bars.push_back(atMost("beads where h < 3 sigma (butt, bead on plate)", flat, 0.0, "sections"));
  bars.back().detail = format("of %.0f", beads);
}

void addHonesty(const Welds& welds, std::vector<Bar>& bars)
{
  for (const Group& sizes : groups())
  {
    const Spread spread = spreadOf(samplesOf(welds, sizes, counts), sizes.folded);
    if (spread.honest_count == 0)
      continue;
    bars.push_back(Bar{ std::string(sizes.name) + ": error / sigma, deviation", "", spread.plain, kLeastHonest,
                        kMostHonest,
                        format("robust %.2f; %.0f values", spread.robust, static_cast<double>(spread.honest_count)) });
  }
}

void addKinds(const Welds& welds, std::vector<Bar>& bars)
{
  double right = 0.0;
  std::string wrong;
  for (const WeldCase& weld : welds)
  {
    if (weld.kind == weld.measured_kind)
      right += 1.0;
    else
      wrong += " " + std::to_string(weld.seed);
  }
  bars.push_back(atLeast("kind: auto right", share(right, static_cast<double>(welds.size())), 98.0, "%"));
  bars.back().detail = wrong.empty() ? "" : "wrong:" + wrong;
}

void addVerdicts(const Welds& welds, std::vector<Bar>& bars)
{
  constexpr double kUndecided = 2.0;  // a limit within so many sigmas leaves it open
  double decided = 0.0, wrong = 0.0, clear = 0.0, clear_decided = 0.0, empty = 0.0, all = 0.0, by_chance = 0.0;
  for (const WeldCase& weld : welds)
  {
    for (const SectionCase& section : weld.sections)
    {
      if (!section.hasBead())
        continue;
      const bool is_decided = !section.verdict.empty() && section.verdict != "undecided";
      all += 1.0, empty += section.verdict.empty() ? 1.0 : 0.0;
      decided += is_decided ? 1.0 : 0.0;
      wrong += is_decided && section.verdict != section.true_verdict ? 1.0 : 0.0;
      clear += section.clear() ? 1.0 : 0.0;
      clear_decided += section.clear() && is_decided ? 1.0 : 0.0;
      by_chance += section.clear() ? 0.5 * std::erfc((section.clearance - kUndecided) / std::sqrt(2.0)) : 0.0;
    }
  }
  bars.push_back(atMost("verdicts: wrong of the decided", share(wrong, decided), 2.5, "%"));
  bars.back().detail =
      format("%.0f of %.0f", wrong, decided) + format("; of %.0f sections %.0f without a verdict", all, empty);
  bars.push_back(atLeast("verdicts: decided where the truth is 4 sigma off", share(clear_decided, clear), 100.0, "%"));
  bars.back().detail = format("%.0f of %.0f left open", clear - clear_decided, clear) +
                       format("; normal errors of the told sigmas leave %.0f", by_chance);
}

void addLabels(const Welds& welds, std::vector<Bar>& bars)
{
  std::array<std::array<long, 5>, 5> labels{};
  std::array<double, 5> below{};
  double wide = 0.0;
  for (const WeldCase& weld : welds)
  {
    if (!(weld.width >= kWideBead))
      continue;
    wide += 1.0;
    for (std::size_t i = 0; i < labels.size(); ++i)
    {
      below[i] += intersectionOverUnion(weld.labels, i) < 0.95 ? 1.0 : 0.0;
      for (std::size_t k = 0; k < labels.size(); ++k)
        labels[i][k] += weld.labels[i][k];
    }
  }
  const std::array<const char*, 2> names = { "base", "bead" };
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    bars.push_back(atLeast(std::string("labels: intersection over union, ") + names[i],
                           intersectionOverUnion(labels, i + 1), 0.95, ""));
    bars.back().detail = format("of %.0f welds %.0f are below", wide, below[i + 1]);
  }
}

void addTimes(const Welds& welds, std::vector<Bar>& bars)
{
  std::vector<double> scans, whole, rows, worst;
  for (const WeldCase& weld : welds)
  {
    scans.push_back(weld.times.measure * kRowsOfBar / weld.rows);
    if (weld.rows >= kNearlyAsManyRows)
      whole.push_back(scans.back());
    rows.push_back(weld.times.row_mean);
    worst.push_back(weld.times.row_worst);
  }
  bars.push_back(atMost("measuring 200 x 1440 points, slowest weld", quantile(scans, 1.0), 100.0, "ms"));
  bars.back().detail = format("median %.1f, ", quantile(scans, 0.5)) +
                       format("shorter scans by the row; slowest of the %.0f with 190 rows or more %.1f",
                              static_cast<double>(whole.size()), quantile(whole, 1.0));
  bars.push_back(atMost("a live section, mean of the slowest weld", quantile(rows, 1.0), 1.0, "ms"));
  bars.back().detail = format("median %.2f, slowest section %.2f", quantile(rows, 0.5), quantile(worst, 1.0));
}
}  // namespace

std::vector<Bar> acceptanceOf(const Welds& welds)
{
  std::vector<Bar> bars;
  addErrors(welds, "width", { 0.03, 0.10 }, bars);
  addErrors(welds, "reinforcement", { 0.01, 0.03 }, bars);
  addErrors(welds, "undercut", { 0.015, 0.04 }, bars);
  addErrors(welds, "misalignment", { 0.01, 0.03 }, bars);
  addErrors(welds, "toe angle", { kNaN, 3.0 }, bars);
  addIntegral(
      welds, "volume", [](const Volumes& v) { return v.measured; }, [](const Volumes& v) { return v.truth; }, bars);
  addIntegral(
      welds, "removal map", [](const Volumes& v) { return v.removal; }, [](const Volumes& v) { return v.true_removal; },
      bars);
  addMeasuredShare(welds, bars);
  addLow(welds, bars);
  addHonesty(welds, bars);
  addKinds(welds, bars);
  addVerdicts(welds, bars);
  addLabels(welds, bars);
  addTimes(welds, bars);
  return bars;
}
}  // namespace weld_accuracy
}  // namespace weld_profiler
