#pragma once

#include <string>
#include <vector>

#include "weld_profiler/weld/limits.h"

namespace weld_profiler
{
/// What makes a table usable as a whole: no two entries for one weld, an imperfection that its kind of weld has, and
/// levels in order (what B allows, C and D allow too).
/// @throws ConfigError naming the entry.
void requireConsistent(const std::vector<LimitEntry>& entries, const std::string& origin);
}  // namespace weld_profiler
