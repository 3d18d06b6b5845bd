#pragma once

#include <string>
#include <vector>

#include "comparison/report.h"

namespace weld_profiler
{
namespace weld_accuracy
{
/// Three welds of 50 mm, each scanned once, and what somebody would read off a weld gauge: the true size, an error of
/// at most 0.1 mm either way, rounded to 0.1 mm, every 5 mm. Printed in short; the sections go to the report's table
/// `gauge`.
void reportGaugeWelds(comparison::Report& report);
}  // namespace weld_accuracy
}  // namespace weld_profiler
