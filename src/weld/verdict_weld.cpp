#include <algorithm>
#include <sstream>

#include "verdict_level.h"
#include "verdict_rows.h"
#include "verdict_sizes.h"
#include "weld_profiler/weld/verdict.h"

namespace weld_profiler
{
namespace
{
constexpr double kMmPerMetre = 1000.0;
constexpr double kThickest = 0.3;    // in one pass of electron beams: what is above was given in another unit [m]
constexpr double kShortWeld = 5e-3;  // a verdict on less says little of a weld [m]

/// From the first section with a bead to the last.
std::vector<WeldSection> withBead(const std::vector<WeldSection>* sections)
{
  if (sections == nullptr)
    return {};
  const auto has_bead = [](const WeldSection& section) { return section.hasBead(); };
  const auto first = std::find_if(sections->begin(), sections->end(), has_bead);
  const auto last = std::find_if(sections->rbegin(), sections->rend(), has_bead).base();
  return first < last ? std::vector<WeldSection>(first, last) : std::vector<WeldSection>();
}

std::string listOf(const std::vector<std::string>& names)
{
  std::string list;
  for (const std::string& name : names)
    list += (list.empty() ? "" : ", ") + name;
  return list;
}

/// Adds the part of one imperfection, if it is judged.
void addPart(const std::vector<VerdictRow>& rows, bool required, std::vector<VerdictPart>& parts)
{
  if (rows.size() != kQualityLevels.size() || rows.front().edition.empty())
    return;
  VerdictPart part{ name(rows.front().imperfection), {}, true };
  for (const VerdictRow& row : rows)
  {
    if (row.decision == Decision::NotJudged || (row.decision == Decision::NotMeasured && !required))
      return;
    const bool any = row.decision == Decision::NotMeasured && row.rule == LevelLimit::Rule::Permitted;
    part.levels[static_cast<std::size_t>(row.level)] = any ? Decision::Pass : row.decision;
    part.verified = part.verified && row.verified;
  }
  parts.push_back(part);
}

WaitingSections waitingOf(const WeldJudge& judge, WeldKind kind, const std::vector<WeldSection>& sections)
{
  WaitingSections waiting;
  for (const WeldSection& section : sections)
  {
    const SectionVerdict verdict = judge.judge(kind, section);
    ++waiting.all;
    waiting.sections += verdict.waits_for.empty() ? 0 : 1;
    for (const std::string& what : verdict.waits_for)
      ++waiting.for_what[what];
  }
  return waiting;
}

void noteThickness(const WeldJudge& judge, std::vector<std::string>& notes)
{
  const std::optional<double>& t = judge.params().thickness;
  std::ostringstream text;
  if (!t)
    return;  // WeldVerdict::lacking()
  if (*t < judge.limits().leastThickness() - 1e-9)
    text << "thickness " << *t * kMmPerMetre << " mm is below the scope of " << judge.limits().standard() << " ("
         << judge.limits().leastThickness() * kMmPerMetre << " mm): measured, not judged";
  else if (*t > kThickest)
    text << "thickness " << *t * kMmPerMetre << " mm is more than is welded: is it given in metres?";
  else
    return;
  notes.push_back(text.str());
}

void noteLength(const WeldVerdict& verdict, std::vector<std::string>& notes)
{
  if (verdict.length >= kShortWeld)
    return;
  if (!(verdict.length > 0.0))
  {
    notes.emplace_back("one section alone was measured, which has no length: nothing of this weld passes");
    return;
  }
  std::ostringstream text;
  text.precision(2);
  text << "only " << verdict.length * kMmPerMetre << " mm of weld were seen: the verdict is about no more than these";
  notes.push_back(text.str());
}

/// From the first section to the last, whatever was measured of them [m].
double seenLength(const std::vector<WeldSection>& sections)
{
  return sections.size() < 2 ? 0.0 : sections.back().s - sections.front().s;
}

void noteRows(const WeldJudge& judge, const VerdictRows& made, const WeldVerdict& verdict,
              std::vector<std::string>& notes)
{
  std::vector<std::string> unverified;
  std::vector<std::string> holes;
  for (const VerdictRow& row : verdict.rows)
  {
    if (row.level != QualityLevel::D || row.edition.empty())
      continue;
    if (!row.verified && row.decision != Decision::NotJudged)
      unverified.push_back(name(row.imperfection));
    if (row.decision == Decision::NotMeasured)
      notes.push_back(std::string(name(row.imperfection)) + " was not measured");
    else if (row.measured < made.needed())
      holes.push_back(name(row.imperfection));
  }
  if (!holes.empty())
    notes.push_back("measured on less than the least share of the weld, so that it cannot pass: " + listOf(holes));
  if (!unverified.empty())
    notes.push_back("limits not checked against a copy of " + judge.limits().standard() + ": " + listOf(unverified));
}

void noteHollows(const WeldToJudge& weld, std::vector<std::string>& notes)
{
  if (weld.hollows == nullptr || weld.hollows->empty())
    return;
  const auto widest =
      std::max_element(weld.hollows->begin(), weld.hollows->end(),
                       [](const WeldSpot& a, const WeldSpot& b) { return a.diameter.value < b.diameter.value; });
  std::ostringstream text;
  text.precision(2);
  text << std::fixed << weld.hollows->size() << (weld.hollows->size() == 1 ? " hollow" : " hollows, the widest")
       << " of " << widest->diameter.value * kMmPerMetre << " mm at s = " << widest->s * kMmPerMetre
       << " mm: a pore or none, it was not seen whole, or no more than stray points";
  notes.push_back(text.str());
}

void noteUnseen(const WeldJudge& judge, const WeldToJudge& weld, std::vector<std::string>& notes)
{
  const double hidden = hiddenPore(weld.unseen_pores);
  if (!(hidden > 0.0) || weld.spots == nullptr || judge.entry(Imperfection::SurfacePore, weld.kind) == nullptr)
    return;
  std::ostringstream text;
  text.precision(2);
  text << std::fixed << "a pore of up to " << hidden * kMmPerMetre
       << " mm, a quarter as deep, would not be seen on this face: its ripples are high, or its rows far apart";
  notes.push_back(text.str());
}

void noteShort(const WeldToJudge& weld, const WeldVerdict& verdict, std::vector<std::string>& notes)
{
  const auto open = [](const VerdictRow& row)
  { return row.rule == LevelLimit::Rule::Short && row.decision == Decision::Undecided && row.length > 0.0; };
  if (weld.runs_out && std::any_of(verdict.rows.begin(), verdict.rows.end(), open))
    notes.emplace_back(
        "the weld runs out of the scan: what is too long for a short imperfection of the length that was "
        "seen may be one of the whole");
}

void conclude(const WeldJudge& judge, const std::vector<VerdictPart>& parts, WeldVerdict& verdict)
{
  const LevelVerdict together = combine(parts);
  verdict.waits_for = missingParts(parts, together);
  verdict.verdict = together.verdict;
  verdict.unverified = together.unverified;
  verdict.levels = together.levels;
  verdict.unverified_levels = together.unverified_levels;
  for (const QualityLevel level : kQualityLevels)
  {
    if (judge.params().level == name(level))
      verdict.asked = together.levels[static_cast<std::size_t>(level)];
  }
  if (verdict.asked == Decision::Pass && !verdict.lacks_thickness.empty())
    verdict.asked = Decision::NotJudged;  // what was not judged may fail it
}

/// What the table limits in welds of this kind and cannot for want of the plate's thickness.
std::vector<std::string> lackingThickness(const WeldJudge& judge, const WeldToJudge& weld)
{
  std::vector<std::string> names;
  for (const Imperfection imperfection : imperfections())
  {
    const bool looked_at = imperfection == Imperfection::SurfacePore
                               ? weld.spots != nullptr
                               : imperfection != Imperfection::ToeAngle || judge.params().judge_toe_angle;
    if (looked_at && !judge.params().thickness &&
        judge.limits().lacksThickness(imperfection, weld.kind, judge.params().nominal_thickness))
      names.push_back(name(imperfection));
  }
  return names;
}
}  // namespace

std::string WeldVerdict::headline() const
{
  if (verdict.empty())
    return "not judged";
  const bool met = verdict != "fail" && verdict != "undecided";
  return met && !lacks_thickness.empty() ? "not fully judged, " + verdict + " by what was judged" : verdict;
}

std::string WeldVerdict::lacking() const
{
  return lacks_thickness.empty() ? "" : "no plate thickness given, not judged: " + listOf(lacks_thickness);
}

std::string WeldVerdict::text() const
{
  return headline() + (lacks_thickness.empty() ? "" : " (" + lacking() + ")") +
         (unverified ? " (limits not verified)" : "");
}

std::string WaitingSections::text() const
{
  if (sections == 0)
    return "";
  std::vector<std::string> counts;
  for (const auto& [what, count] : for_what)
    counts.push_back(what + " " + std::to_string(count));
  return std::to_string(sections) + " of " + std::to_string(all) +
         (sections == 1 ? " sections waits" : " sections wait") + " for what was not measured there: " + listOf(counts);
}

WeldVerdict WeldJudge::judge(const WeldToJudge& weld) const
{
  WeldVerdict result;
  const std::vector<WeldSection> sections = withBead(weld.sections);
  if (weld.kind == WeldKind::None || sections.empty())
  {
    result.levels.fill(Decision::NotMeasured);
    result.asked = Decision::NotMeasured;
    result.notes.emplace_back("no weld was measured: there is nothing to judge");
    return result;
  }
  const VerdictRows rows(*this, weld.kind, sections, SeenLength{ seenLength(*weld.sections), weld.runs_out });
  result.length = rows.length();
  std::vector<VerdictPart> parts;
  for (const Imperfection imperfection : imperfections())
  {
    const bool decides = imperfection != Imperfection::ToeAngle || params_.judge_toe_angle;
    std::vector<VerdictRow> made;
    if (imperfection != Imperfection::SurfacePore)
      made = rows.rows(imperfection, decides);
    else if (weld.spots != nullptr)
      made = rows.poreRows(weld);
    addPart(made, decidesSections(imperfection, params_.judge_toe_angle), parts);
    result.rows.insert(result.rows.end(), made.begin(), made.end());
  }
  result.lacks_thickness = lackingThickness(*this, weld);
  conclude(*this, parts, result);
  result.waiting = waitingOf(*this, weld.kind, sections);
  if (!result.lacks_thickness.empty())
    result.notes.push_back(result.lacking());
  noteThickness(*this, result.notes);
  noteLength(result, result.notes);
  noteRows(*this, rows, result, result.notes);
  noteHollows(weld, result.notes);
  noteUnseen(*this, weld, result.notes);
  noteShort(weld, result, result.notes);
  if (result.waiting.sections > 0)
    result.notes.push_back(result.waiting.text());
  return result;
}
}  // namespace weld_profiler
