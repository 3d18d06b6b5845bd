#pragma once

#include <array>
#include <string>
#include <vector>

#include "weld/weld_case.h"

namespace weld_profiler
{
namespace weld_accuracy
{
/// What a weld is judged after.
struct Judging
{
  std::string kind;        ///< the true one
  double thickness = 0.0;  ///< [m]
  bool toe_angle = false;
};

/// Best level that the true sizes meet: B, C, D or fail. ISO 5817 written down a second time, sharing no code and no
/// table with weld/: what WeldJudge says is judged by it.
std::string trueVerdict(const Judging& judging, const std::array<Deviation, kSizes>& sizes);

/// How far the truth lies from the nearest limit, in the sigmas told by the measurement.
/// @return 0 when a size that decides was not measured.
double clearanceOf(const Judging& judging, const std::array<Deviation, kSizes>& sizes);
}  // namespace weld_accuracy
}  // namespace weld_profiler
