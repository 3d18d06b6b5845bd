#pragma once

#include <string>

#include "weld_profiler/core/scan.h"

namespace weld_profiler
{
/// The valid points of a scan as text, a line each, after the header
/// `row,cell,x_m,y_m,z_m,intensity,sigma_m,stage_m,time_s,flags`. Nine digits, enough to read the same floats back.
std::string csvText(const Scan& scan);
}  // namespace weld_profiler
