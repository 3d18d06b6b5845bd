#pragma once

#include "weld_profiler/core/scan.h"
#include "weld_profiler/simulation/simulated_scan.h"

namespace weld_profiler
{
/// The organised scan that the chain makes of a simulated one: each frame is rendered, its stripe found (default
/// method), triangulated and placed by the encoder, with the stages that the nodelets and scan_bag drive and all their
/// defaults; no bag, no ROS. The same scene gives the same scan. Thread safe.
/// @throws InputError when frames were lost on the way or the scan fell into pieces.
Scan simulatedCloud(const SimulatedScan& simulated);
}  // namespace weld_profiler
