#include <algorithm>

#include "verdict_level.h"
#include "verdict_notes.h"
#include "verdict_rows.h"
#include "verdict_sizes.h"
#include "weld_profiler/weld/verdict.h"

namespace weld_profiler
{
namespace
{
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

/// From the first section to the last, whatever was measured of them [m].
double seenLength(const std::vector<WeldSection>& sections)
{
  return sections.size() < 2 ? 0.0 : sections.back().s - sections.front().s;
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
  result.notes = verdictNotes(*this, weld, rows, result);
  return result;
}
}  // namespace weld_profiler
