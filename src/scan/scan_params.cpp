#include "weld_profiler/scan/scan_params.h"

#include <array>
#include <sstream>

#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
namespace
{
constexpr double kFarthest = 1e6;  // [m], of a window's side

void requireWindow(const std::string& axis, double low, double high)
{
  requireRange("min_" + axis, low, -kFarthest, kFarthest, "m");
  requireRange("max_" + axis, high, -kFarthest, kFarthest, "m");
  if (low < high)
    return;
  std::ostringstream text;
  text << "min_" << axis << " is " << low << ", must be less than max_" << axis << " (" << high << ") m";
  throw ConfigError(text.str());
}
}  // namespace

void ScanParams::validate() const
{
  requireOneOf("trigger", trigger, std::array<std::string, 2>{ { "distance", "time" } });
  requireRange("pitch", pitch, 0.0, 1.0, "m");
  requireRange("still_tolerance", still_tolerance, 0.0, 1.0, "m");
  requireOneOf("on_reversal", on_reversal, std::array<std::string, 2>{ { "split", "ignore" } });
  requireRange("reversal_hysteresis", reversal_hysteresis, 1e-9, 1.0, "m");
  requireRange("max_rows", max_rows, 1, 1000000);
  requireRange("max_waiting", max_waiting, 1, 100000);
  requireWindow("x", min_x, max_x);
  requireWindow("y", min_y, max_y);
  requireWindow("z", min_z, max_z);
}
}  // namespace weld_profiler
