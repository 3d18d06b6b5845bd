#include "weld_profiler/weld/weld_evaluation.h"

namespace weld_profiler
{
WeldEvaluator::WeldEvaluator(const WeldSettings& settings)
  : settings_(settings), measurer_(settings.measuring), judge_(settings.judging)
{
  settings_.validate();
}

WeldEvaluation WeldEvaluator::evaluate(const Scan& scan) const
{
  WeldEvaluation evaluation;
  evaluation.result = measurer_.measure(scan);
  const WeldResult& result = evaluation.result;
  evaluation.plan = planGrinding(scan, result, settings_.grinding);
  if (!result.hasWeld())
    return evaluation;
  for (const WeldSection& section : result.sections)
    evaluation.section_verdicts.push_back(judge_.judge(result.kind, section));
  evaluation.verdict = judge_.judge(WeldToJudge{ result.kind, &result.sections, &result.spots, &result.hollows,
                                                 result.unseen_pores, result.runs_out });
  const Imperfection height = result.kind == WeldKind::Fillet ? Imperfection::Convexity : Imperfection::ExcessWeldMetal;
  if (const LimitEntry* entry = judge_.entry(height, result.kind))
    evaluation.height_limits = *entry;
  return evaluation;
}
}  // namespace weld_profiler
