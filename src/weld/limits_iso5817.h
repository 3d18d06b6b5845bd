#pragma once

namespace weld_profiler
{
/// The text of config/limits/iso5817.yaml, so that a table is at hand wherever the library runs.
extern const char* const kIso5817Table;
}  // namespace weld_profiler
