#pragma once

#include <limits>
#include <string>

namespace weld_profiler
{
/// How placed profiles become scans.
struct ScanParams
{
  std::string trigger = "distance";    ///< distance: a row each time the stage moved by pitch; time: a row a frame
  double pitch = 0.0;                  ///< [m], >= 0; 0 = any movement beyond still_tolerance
  double still_tolerance = 2e-6;       ///< the stage stands still within this [m], with pitch 0
  std::string on_reversal = "split";   ///< split: a reversal closes the scan; ignore
  double reversal_hysteresis = 5e-4;   ///< way back that counts as a reversal [m], > 0
  int max_rows = 20000;                ///< closes a scan and begins the next, 1..1000000
  int max_waiting = 256;               ///< profiles that may wait for their bracketing sample, 1..100000
  double min_x = -10.0, max_x = 10.0;  ///< metric window in the cloud's frame [m]
  double min_y = -1000.0, max_y = 1000.0;
  double min_z = -10.0, max_z = 10.0;

  /// @throws ConfigError naming field, value and range.
  void validate() const;

  template <class Visitor>
  void visit(Visitor&& v)
  {
    v("trigger", trigger);
    v("pitch", pitch);
    v("still_tolerance", still_tolerance);
    v("on_reversal", on_reversal);
    v("reversal_hysteresis", reversal_hysteresis);
    v("max_rows", max_rows);
    v("max_waiting", max_waiting);
    v("min_x", min_x);
    v("max_x", max_x);
    v("min_y", min_y);
    v("max_y", max_y);
    v("min_z", min_z);
    v("max_z", max_z);
  }
};
}  // namespace weld_profiler
