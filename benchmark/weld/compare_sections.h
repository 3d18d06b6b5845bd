#pragma once

#include <vector>

#include "weld/limits_again.h"
#include "weld/weld_case.h"
#include "weld_profiler/core/scan.h"
#include "weld_profiler/simulation/simulated_scan.h"
#include "weld_profiler/weld/verdict.h"
#include "weld_profiler/weld/weld_result.h"

namespace weld_profiler
{
namespace weld_accuracy
{
/// A weld, what was measured of it and what judges it.
struct MeasuredWeld
{
  const SimulatedScan& simulated;
  const Scan& scan;
  const WeldResult& result;
  const WeldJudge& judge;
  Judging judging;
};

/// Which bars hold for a true section.
Stature statureOf(const WeldTruth& truth);

/// Each measured section beside the true one through its place: the middle of its toes, or where these were not
/// measured its point of the path.
std::vector<SectionCase> compareSections(const MeasuredWeld& weld);

/// True sections, one a frame, and which of them have a measured section with a width within a frame's step.
Shares compareShares(const MeasuredWeld& weld, const std::vector<SectionCase>& sections);

/// Volume of the measured sections; removal over the stretch of weld that lies wholly in the scan.
Volumes compareVolumes(const MeasuredWeld& weld, const std::vector<SectionCase>& sections);

/// Points of the scan by true and by measured label.
std::array<std::array<long, 5>, 5> compareLabels(const MeasuredWeld& weld);
}  // namespace weld_accuracy
}  // namespace weld_profiler
