#include "weld_profiler/weld/verdict.h"

#include <cmath>

#include "verdict_level.h"
#include "verdict_sizes.h"
#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
namespace
{
const VerdictParams& checked(const VerdictParams& params)
{
  params.validate();
  return params;
}
VerdictPart partOf(const Judgement& judgement, const LimitEntry& limit, const WeldSection& section)
{
  VerdictPart part{ name(judgement.imperfection), {}, limit.verified };
  if (!judgement.side.empty())
    part.name += " " + judgement.side;
  for (const QualityLevel level : kQualityLevels)
  {
    Decision decision = judgement.at(level).decision;
    if (decision == Decision::NotMeasured && limit.at(level).rule == LevelLimit::Rule::Permitted)
      decision = Decision::Pass;  // whatever its size is
    // where no bead was measured plates that lie well are no reason to expect that it is good
    if (!section.hasBead() && decision != Decision::Fail)
      decision = Decision::NotMeasured;
    part.levels[static_cast<std::size_t>(level)] = decision;
  }
  return part;
}
}  // namespace

const char* name(Decision decision)
{
  constexpr std::array<const char*, 5> kNames = { { "", "not_judged", "pass", "fail", "undecided" } };
  return kNames[static_cast<std::size_t>(decision)];
}

WeldJudge::WeldJudge(const VerdictParams& params)
  : WeldJudge(checked(params), params.limits_file.empty() ? Limits::shipped() : Limits::load(params.limits_file))
{
}

WeldJudge::WeldJudge(const VerdictParams& params, Limits limits) : params_(checked(params)), limits_(std::move(limits))
{
}

const LimitEntry* WeldJudge::entry(Imperfection imperfection, WeldKind kind) const
{
  const std::optional<double> s = params_.nominal_thickness ? params_.nominal_thickness : params_.thickness;
  return limits_.find(imperfection, kind, params_.thickness, s);
}

LimitDimensions WeldJudge::dimensions(const WeldSection& section) const
{
  const std::optional<double> s = params_.nominal_thickness ? params_.nominal_thickness : params_.thickness;
  return { section.width, section.throat, params_.thickness, s };
}

Comparison WeldJudge::compare(const LimitEntry& entry, QualityLevel level, const Quantity& value,
                              const LimitDimensions& dimensions) const
{
  const LevelLimit& rule = entry.at(level);
  Comparison result;
  if (rule.rule == LevelLimit::Rule::Permitted)
  {
    result.decision = value.measured() ? Decision::Pass : Decision::NotMeasured;
    return result;
  }
  result.limit = rule.rule == LevelLimit::Rule::NotPermitted ? Quantity{ params_.smallest_imperfection, 0.0 }
                                                             : evaluate(rule, dimensions);
  if (value.measured() && result.limit.measured())
  {
    // size and dimension share the toes, but a toe that slides along its plate moves b and leaves h: independent
    result.margin.value = (entry.least ? -1.0 : 1.0) * (result.limit.value - value.value);
    result.margin.sigma = std::hypot(value.sigma, result.limit.sigma);
  }
  result.decision = decide(result.margin);
  return result;
}

SectionVerdict WeldJudge::judge(WeldKind kind, const WeldSection& section) const
{
  SectionVerdict result;
  std::vector<VerdictPart> parts;
  for (const ImperfectionSize& size : sizesOf(kind, section))
  {
    Judgement judgement;
    judgement.imperfection = size.imperfection;
    judgement.side = size.side;
    judgement.value = size.value;
    if (const LimitEntry* limit = entry(size.imperfection, kind))
    {
      for (const QualityLevel level : kQualityLevels)
        judgement.levels[static_cast<std::size_t>(level)] = compare(*limit, level, size.value, dimensions(section));
      judgement.verified = limit->verified;
      judgement.decides = decidesSections(size.imperfection, params_.judge_toe_angle);
      if (judgement.decides)
        parts.push_back(partOf(judgement, *limit, section));
    }
    result.judgements.push_back(judgement);
  }
  const LevelVerdict together = combine(parts);
  result.verdict = together.verdict;
  if (result.verdict == "undecided")  // what is not judged at all waits for nothing
    result.waits_for = missingParts(parts, together);
  result.unverified = together.unverified;
  result.levels = together.levels;
  result.unverified_levels = together.unverified_levels;
  return result;
}
}  // namespace weld_profiler
