#pragma once

#include <diagnostic_updater/diagnostic_updater.h>

#include "weld_profiler/core/balance.h"
#include "weld_profiler/ros/age_statistics.h"

namespace weld_profiler
{
/// Adds rate and age of data: `rate [Hz]`, `age p50 [ms]`, `age p99 [ms]`, `age max [ms]`.
void reportAge(const AgeStatistics::Summary& age, diagnostic_updater::DiagnosticStatusWrapper& status);

/// Adds where the frames went: `frames in`, `rows`, `no stripe`, `skipped`, `waiting`, and a line a reason for
/// `unplaced` and `dropped`. Level WARN when anything is unplaced or dropped.
void reportBalance(const FrameBalance& balance, std::size_t waiting,
                   diagnostic_updater::DiagnosticStatusWrapper& status);
}  // namespace weld_profiler
