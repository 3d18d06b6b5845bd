#pragma once

#include <ostream>

#include "weld_profiler/weld/verdict.h"

namespace weld_profiler
{
/// Writes verdict.csv: after the header a line for each imperfection and level, then three for the weld as a whole
/// (imperfection `weld`). Millimetres; the toe angle stands in the columns `_deg`. An empty field = not measured, or no
/// limit. A decimal point whatever the locale. The stream's state tells whether it could be written.
void writeVerdictCsv(const WeldVerdict& verdict, std::ostream& out);
}  // namespace weld_profiler
