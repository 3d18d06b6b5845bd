#pragma once

#include <optional>
#include <vector>

#include "weld_profiler/core/scan.h"
#include "weld_profiler/weld/grinding.h"
#include "weld_profiler/weld/verdict.h"
#include "weld_profiler/weld/weld_measurer.h"

namespace weld_profiler
{
/// How a scan is measured, judged and to be ground.
struct WeldSettings
{
  WeldParams measuring;
  VerdictParams judging;
  GrindingParams grinding;

  /// @throws ConfigError naming field, value and range.
  void validate() const
  {
    measuring.validate();
    judging.validate();
    grinding.validate();
  }

  template <class Visitor>
  void visit(Visitor&& v)
  {
    measuring.visit(v);
    judging.visit(v);
    grinding.visit(v);
  }
};

/// A scan, measured and judged.
struct WeldEvaluation
{
  WeldResult result;
  std::vector<SectionVerdict> section_verdicts;  ///< one a section of the result
  WeldVerdict verdict;                           ///< empty where there is no weld
  std::optional<LimitEntry> height_limits;       ///< of the reinforcement or convexity; none = there are none
  GrindingPlan plan;                             ///< without passes where there is no weld
};

/// Measures a scan, judges what was measured and plans the grinding. Immutable, thread safe.
class WeldEvaluator
{
public:
  /// @throws ConfigError naming field, value and range; InputError for a table of limits that cannot be read.
  explicit WeldEvaluator(const WeldSettings& settings);

  WeldEvaluation evaluate(const Scan& scan) const;

  const WeldSettings& settings() const { return settings_; }
  const WeldMeasurer& measurer() const { return measurer_; }
  const WeldJudge& judge() const { return judge_; }

private:
  WeldSettings settings_;
  WeldMeasurer measurer_;
  WeldJudge judge_;
};
}  // namespace weld_profiler
