#include "verdict_level.h"

#include <algorithm>

namespace weld_profiler
{
namespace
{
constexpr double kPassSigmas = 2.0;
constexpr double kRounding = 1e-12;  // a size at its limit is within it [m or rad]

Decision levelOf(const std::vector<VerdictPart>& parts, std::size_t level)
{
  const auto any = [&](Decision decision)
  {
    return std::any_of(parts.begin(), parts.end(),
                       [=](const VerdictPart& part) { return part.levels[level] == decision; });
  };
  if (any(Decision::Fail))
    return Decision::Fail;
  if (any(Decision::Undecided) || (any(Decision::Pass) && any(Decision::NotMeasured)))
    return Decision::Undecided;
  return any(Decision::Pass)          ? Decision::Pass
         : any(Decision::NotMeasured) ? Decision::NotMeasured
                                      : Decision::NotJudged;
}

/// Whether what is said of a level rests on a limit that was not read. One failure by a limit that was is enough.
bool unverifiedAt(const std::vector<VerdictPart>& parts, std::size_t level, Decision decision)
{
  if (decision == Decision::NotJudged || decision == Decision::NotMeasured)
    return false;
  if (decision == Decision::Fail)
    return std::none_of(parts.begin(), parts.end(),
                        [=](const VerdictPart& part) { return part.verified && part.levels[level] == Decision::Fail; });
  return std::any_of(parts.begin(), parts.end(), [](const VerdictPart& part) { return !part.verified; });
}
}  // namespace

Decision decide(const Quantity& margin, double fail_sigmas)
{
  if (!margin.measured())
    return Decision::NotMeasured;
  if (margin.value + kRounding >= kPassSigmas * margin.sigma)
    return Decision::Pass;
  return margin.value <= -fail_sigmas * margin.sigma ? Decision::Fail : Decision::Undecided;
}

std::vector<std::string> missingParts(const std::vector<VerdictPart>& parts, const LevelVerdict& together)
{
  std::vector<std::string> missing;
  const auto level = std::find_if(together.levels.begin(), together.levels.end(),
                                  [](Decision decision) { return decision != Decision::Fail; });
  if (level == together.levels.end() || *level == Decision::Pass)
    return missing;
  for (const VerdictPart& part : parts)
  {
    if (part.levels[static_cast<std::size_t>(level - together.levels.begin())] == Decision::NotMeasured)
      missing.push_back(part.name);
  }
  return missing;
}

LevelVerdict combine(const std::vector<VerdictPart>& parts)
{
  LevelVerdict result;
  for (std::size_t level = 0; level < kQualityLevels.size(); ++level)
  {
    result.levels[level] = levelOf(parts, level);
    result.unverified_levels[level] = unverifiedAt(parts, level, result.levels[level]);
  }
  result.verdict = "fail";
  result.unverified = result.unverified_levels.back();
  for (std::size_t level = 0; level < kQualityLevels.size(); ++level)
  {
    const Decision decision = result.levels[level];
    if (decision == Decision::Fail)
      continue;
    result.verdict =
        decision == Decision::Pass ? name(kQualityLevels[level]) : (decision == Decision::Undecided ? "undecided" : "");
    result.unverified = result.unverified_levels[level];
    break;
  }
  return result;
}
}  // namespace weld_profiler
