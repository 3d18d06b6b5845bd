#pragma once

#include <string>

#include "weld_profiler/core/scan.h"

namespace weld_profiler
{
/// Reads an organised PCD cloud back as a scan: a row of the cloud a profile, a column a cell, whatever the DATA form
/// (ascii, binary, compressed). x y z FLOAT32 must be there; intensity, sigma, stage, time (FLOAT32) and flags (UINT8)
/// are taken where they are, other fields are passed over. A point without a usable sigma gets 10 um. Stamps count from
/// the first row; the frame is not in the file.
/// @throws InputError naming path, cause and remedy.
Scan loadScan(const std::string& path);
}  // namespace weld_profiler
