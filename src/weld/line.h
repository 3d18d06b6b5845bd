#pragma once

#include <cmath>

#include "weld_profiler/weld/quantity.h"

namespace weld_profiler
{
namespace weld
{
/// A straight line z = height + slope q over the place q across the weld.
struct Line
{
  double height = std::numeric_limits<double>::quiet_NaN();
  double slope = std::numeric_limits<double>::quiet_NaN();

  bool valid() const { return std::isfinite(height) && std::isfinite(slope); }
  double at(double q) const { return height + slope * q; }
  double angle() const { return std::atan(slope); }

  /// Distance of a point above the line.
  double above(double q, double z) const { return (z - at(q)) / std::sqrt(1.0 + slope * slope); }
};
}  // namespace weld
}  // namespace weld_profiler
