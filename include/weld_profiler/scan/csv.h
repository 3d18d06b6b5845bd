#pragma once

#include <ostream>

#include "weld_profiler/core/scan.h"

namespace weld_profiler
{
/// Writes the valid points of a scan, a line each, after the header
/// `row,cell,x_m,y_m,z_m,intensity,sigma_m,stage_m,time_s,flags`. Nine digits, enough to read the same floats back; a
/// decimal point whatever the locale. The stream's state tells whether it could be written.
void writeCsv(const Scan& scan, std::ostream& out);
}  // namespace weld_profiler
