#include "verdict_rows.h"

#include <algorithm>
#include <cmath>

#include "verdict_level.h"
#include "verdict_sizes.h"

namespace weld_profiler
{
VerdictRow emptyRow(Imperfection imperfection, QualityLevel level, const LimitEntry* entry)
{
  VerdictRow row;
  row.imperfection = imperfection;
  row.level = level;
  if (entry != nullptr)
  {
    row.rule = entry->at(level).rule;
    row.edition = entry->edition;
    row.verified = entry->verified;
  }
  return row;
}

void setPlace(const Place& place, bool with_limit, VerdictRow& row)
{
  row.value = place.value;
  row.limit = with_limit ? place.limit : Quantity{};
  row.margin = with_limit ? place.margin : Quantity{};
  row.side = place.side;
  row.s = place.s;
}

namespace
{
using Rule = LevelLimit::Rule;

constexpr double kOfSeen = 0.7;     // of the length over which a weld was seen it has to be measured
constexpr double kRounding = 1e-9;  // of lengths [m]

std::vector<double> positions(const std::vector<WeldSection>& sections)
{
  std::vector<double> s;
  s.reserve(sections.size());
  for (const WeldSection& section : sections)
    s.push_back(section.s);
  return s;
}

/// Cells that count more than once, merged: no stretch lies over another.
class CellWeights
{
public:
  explicit CellWeights(const std::vector<Stretch>& cells) : stretches_(cells)
  {
    for (Stretch& stretch : stretches_)
      stretch.weight = 0.0;
  }
  void add(std::size_t cell) { stretches_[cell].weight += 1.0; }
  const std::vector<Stretch>& stretches() const { return stretches_; }

private:
  std::vector<Stretch> stretches_;
};

/// A lone section with an imperfection: its length is not known.
bool lone(const CellWeights& cells)
{
  return cells.stretches().size() == 1 && cells.stretches().front().weight > 0.0;
}
}  // namespace

VerdictRows::VerdictRows(const WeldJudge& judge, WeldKind kind, const std::vector<WeldSection>& sections,
                         const SeenLength& seen)
  : judge_(judge), kind_(kind), sections_(sections), cells_(cellsOf(positions(sections))), longer_(seen.longer)
{
  if (!cells_.empty())
    length_ = cells_.back().end - cells_.front().begin;
  needed_ = judge.params().min_measured_share * std::max(length_, kOfSeen * seen.seen) - kRounding;
}

std::vector<Place> VerdictRows::places(const SizeSeries& series, const LimitEntry* entry, QualityLevel level) const
{
  const bool limited = entry != nullptr && entry->at(level).rule != Rule::Permitted;
  std::vector<Place> result;
  for (std::size_t i = 0; i < sections_.size(); ++i)
  {
    Place place;
    place.side = series.side;
    place.cell = i;
    place.s = sections_[i].s;
    place.value = series.values[i];
    if (limited)
    {
      const Comparison comparison = judge_.compare(*entry, level, place.value, judge_.dimensions(sections_[i]));
      place.limit = comparison.limit;
      place.margin = comparison.margin;
    }
    else
    {
      // the worst is still found by its margin, from a limit of zero
      const bool least = entry != nullptr && entry->least;
      place.margin = { least ? place.value.value : -place.value.value, place.value.sigma };
    }
    if (place.margin.measured())
      result.push_back(place);
  }
  return result;
}

double VerdictRows::measuredLength(const std::vector<SizeSeries>& all) const
{
  double length = 0.0;
  for (std::size_t i = 0; i < cells_.size(); ++i)
  {
    if (std::all_of(all.begin(), all.end(), [i](const SizeSeries& series) { return series.values[i].measured(); }))
      length += cells_[i].end - cells_[i].begin;
  }
  return length;
}

void VerdictRows::judgeLength(const std::vector<SizeSeries>& all, const std::vector<Place>& medians,
                              VerdictRow& row) const
{
  const double smallest = judge_.params().smallest_imperfection;
  const std::vector<double> sigmas = failSigmas(medians);
  CellWeights likely(cells_);
  CellWeights certain(cells_);
  CellWeights possible(cells_);
  for (std::size_t i = 0; i < medians.size(); ++i)
  {
    const Quantity below = { smallest - medians[i].value.value, medians[i].value.sigma };
    const Decision none = decide(below, sigmas[i]);
    if (below.value < 0.0)
      likely.add(medians[i].cell);
    if (none == Decision::Fail)
      certain.add(medians[i].cell);
    if (none != Decision::Pass)
      possible.add(medians[i].cell);
  }
  for (const SizeSeries& series : all)
    for (std::size_t i = 0; i < cells_.size(); ++i)
    {
      if (!series.values[i].measured())
        possible.add(i);
    }
  std::vector<Stretch> most = possible.stretches();
  const std::vector<Stretch> gaps = gapsBetween(cells_, static_cast<double>(all.size()));
  most.insert(most.end(), gaps.begin(), gaps.end());

  const ShortRule& rule = judge_.limits().shortRule();
  const double window = std::min(rule.per, length_);
  const double allowed = length_ < rule.per - kRounding ? rule.share * length_ : rule.length;
  // the more of a longer weld, up to what any may have
  const double most_allowed = longer_ ? std::max(allowed, rule.length) : allowed;
  row.length = mostWithin(likely.stretches(), window);
  row.verified = row.verified && rule.verified;
  if (mostWithin(certain.stretches(), window) > most_allowed + kRounding)
    row.decision = Decision::Fail;
  else if (row.decision == Decision::Pass && (mostWithin(most, window) > allowed + kRounding || lone(possible)))
    row.decision = Decision::Undecided;
}

VerdictRow VerdictRows::row(const std::vector<SizeSeries>& all, Imperfection imperfection, QualityLevel level) const
{
  const LimitEntry* entry = judge_.entry(imperfection, kind_);
  VerdictRow result = emptyRow(imperfection, level, entry);
  std::vector<Place> singles;
  std::vector<Place> medians;
  for (const SizeSeries& series : all)
  {
    const std::vector<Place> side = places(series, entry, level);
    const std::vector<Place> smooth = runningMedians(side, judge_.params().min_length);
    singles.insert(singles.end(), side.begin(), side.end());
    medians.insert(medians.end(), smooth.begin(), smooth.end());
  }
  result.measured = measuredLength(all);
  const SizeDecision size = decideSize(singles, medians);
  if (size.decision == Decision::NotMeasured)
    return result;
  const bool limited = entry != nullptr && result.rule != Rule::Permitted;
  setPlace(size.place, limited, result);
  if (!limited)
  {
    result.decision = entry == nullptr ? Decision::NotJudged : Decision::Pass;
    return result;
  }
  result.decision = size.decision;
  result.length = 0.0;
  for (const Place& place : medians)
    result.length += place.margin.value < 0.0 ? cells_[place.cell].end - cells_[place.cell].begin : 0.0;
  if (result.decision == Decision::Pass &&
      (result.measured < needed_ || !(result.measured > 0.0)))  // of no length nothing is shown
    result.decision = Decision::Undecided;
  if (result.rule == Rule::Short)
    judgeLength(all, medians, result);
  return result;
}

std::vector<VerdictRow> VerdictRows::rows(Imperfection imperfection, bool decides) const
{
  std::vector<SizeSeries> all;
  for (std::size_t i = 0; i < sections_.size(); ++i)
  {
    std::size_t index = 0;
    for (const ImperfectionSize& size : sizesOf(kind_, sections_[i]))
    {
      if (size.imperfection != imperfection)
        continue;
      if (i == 0)
        all.push_back({ size.side, {} });
      all[index++].values.push_back(size.value);
    }
  }
  std::vector<VerdictRow> result;
  if (all.empty())
    return result;
  for (const QualityLevel level : kQualityLevels)
  {
    result.push_back(row(all, imperfection, level));
    if (!decides && result.back().decision != Decision::NotMeasured)
      result.back().decision = Decision::NotJudged;
  }
  return result;
}
}  // namespace weld_profiler
