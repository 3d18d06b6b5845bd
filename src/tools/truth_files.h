#pragma once

#include <string>

#include "weld_profiler/simulation/simulated_scan.h"

namespace weld_profiler
{
/// Writes what is true of a simulated scan into an existing directory: centres.csv
/// (`frame,stamp,stage_m,cell,u_px,v_px, normal_rad,x_m,y_m,z_m,visible`), scene.yaml and calibration.yaml. Same scan
/// -> same bytes.
/// @throws InputError naming the file.
void writeTruthFiles(const SimulatedScan& scan, const SceneParams& scene, const std::string& directory);
}  // namespace weld_profiler
