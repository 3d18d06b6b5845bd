#pragma once

#include "scan_grid.h"
#include "weld_profiler/weld/weld_spot.h"

namespace weld_profiler
{
namespace weld
{
/// What pores a face may have beside those that are told.
/// @param depth  a pit whose bottom is seen less deep is not told [m].
UnseenPores unseenPores(const ScanGrid& grid, double depth);
}  // namespace weld
}  // namespace weld_profiler
