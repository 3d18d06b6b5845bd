#pragma once

#include <array>
#include <string>
#include <vector>

#include "weld_profiler/weld/verdict.h"

namespace weld_profiler
{
/// What one imperfection says of each level.
struct VerdictPart
{
  std::string name;                ///< of the imperfection, with its side
  std::array<Decision, 3> levels;  ///< B, C, D
  bool verified;
};

/// What all imperfections together say.
struct LevelVerdict
{
  std::string verdict;  ///< best level met, fail, undecided, or empty
  bool unverified = false;
  std::array<Decision, 3> levels;
  std::array<bool, 3> unverified_levels;
};

/// A level is failed by one certain failure, and met when every part meets it; not measured if no part was measured.
/// The verdict is the best level met; it is undecided only if a better level is neither met nor failed with certainty
/// (for want of a part, too), for then the best one is not known.
LevelVerdict combine(const std::vector<VerdictPart>& parts);

/// Names of the parts that were not measured and keep the verdict open: at the best level that has not failed.
std::vector<std::string> missingParts(const std::vector<VerdictPart>& parts, const LevelVerdict& together);

/// Pass from 2 sigma above zero, fail from `fail_sigmas` below, undecided between; a margin of exactly zero passes.
Decision decide(const Quantity& margin, double fail_sigmas = 2.0);
}  // namespace weld_profiler
