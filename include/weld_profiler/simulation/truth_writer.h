#pragma once

#include <functional>
#include <string>

#include "weld_profiler/simulation/simulated_scan.h"

namespace weld_profiler
{
/// Told how many of all frames are written.
using TruthProgress = std::function<void(int done, int total)>;

/// Writes a folder with what is true of a scan: centres.csv, surface.ply, weld.csv, spots.csv, scene.yaml. The folder
/// appears whole or not at all; one that holds the truth of an earlier scan is replaced, any other is refused.
/// @param directory  is made; its parent must exist.
/// @throws InputError naming the path.
void writeTruth(const SimulatedScan& scan, const std::string& directory, const TruthProgress& progress = {});
}  // namespace weld_profiler
