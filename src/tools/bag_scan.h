#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "weld_profiler/core/balance.h"
#include "weld_profiler/core/scan.h"
#include "weld_profiler/ros/scan_chain.h"
#include "weld_profiler/stripe/stripe_params.h"

namespace weld_profiler
{
/// What to do with a bag.
struct BagScanParams
{
  std::string bag;
  std::string name_space;  ///< of image_raw in the bag; empty = the only one there is
  Calibration calibration;
  StripeParams stripe;
  ScanChainParams chain;
};

/// What became of it.
struct BagScanResult
{
  std::string name_space;
  std::vector<Scan> scans;  ///< in the order they ended, each with at least one row
  FrameBalance balance;
  std::uint64_t frame_gaps = 0;  ///< frames missing in the bag by the driver's counter; not part of frames_in
};

/// Reads a bag through the stages of the live chain, every message, in the bag's order, without a ROS master.
/// @throws InputError when the bag cannot be read or lacks topic, joint or frame, naming it and the remedy.
BagScanResult scanBag(const BagScanParams& params);
}  // namespace weld_profiler
