#pragma once

#include "weld/weld_case.h"

namespace weld_profiler
{
namespace weld_accuracy
{
/// Renders randomWeldScene(seed), sends it through the chain, measures, judges and compares. Thread safe.
/// @throws Error when the scene does not become one scan.
WeldCase runCase(std::uint64_t seed);

/// Renders and measures a weld once more: of its times the shorter count. @throws as runCase.
void timeAgain(WeldCase& weld);

/// Processor time of the calling thread [ms].
double processorMs();
}  // namespace weld_accuracy
}  // namespace weld_profiler
