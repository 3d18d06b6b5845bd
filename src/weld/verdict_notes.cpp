#include "verdict_notes.h"

#include <algorithm>
#include <sstream>

namespace weld_profiler
{
namespace
{
constexpr double kMmPerMetre = 1000.0;
constexpr double kThickest = 0.3;    // in one pass of electron beams: what is above was given in another unit [m]
constexpr double kShortWeld = 5e-3;  // a verdict on less says little of a weld [m]

std::string listOf(const std::vector<std::string>& names)
{
  std::string list;
  for (const std::string& name : names)
    list += (list.empty() ? "" : ", ") + name;
  return list;
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
}  // namespace

std::vector<std::string> verdictNotes(const WeldJudge& judge, const WeldToJudge& weld, const VerdictRows& made,
                                      const WeldVerdict& verdict)
{
  std::vector<std::string> notes;
  if (!verdict.lacks_thickness.empty())
    notes.push_back(verdict.lacking());
  noteThickness(judge, notes);
  noteLength(verdict, notes);
  noteRows(judge, made, verdict, notes);
  noteHollows(weld, notes);
  noteUnseen(judge, weld, notes);
  noteShort(weld, verdict, notes);
  if (verdict.waiting.sections > 0)
    notes.push_back(verdict.waiting.text());
  return notes;
}

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
}  // namespace weld_profiler
