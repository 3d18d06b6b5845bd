#pragma once

#include <cmath>
#include <limits>

namespace weld_profiler
{
/// A measured value and its 1-sigma uncertainty, in the same SI unit. NaN = not measured.
struct Quantity
{
  double value = std::numeric_limits<double>::quiet_NaN();
  double sigma = std::numeric_limits<double>::quiet_NaN();

  bool measured() const { return std::isfinite(value) && std::isfinite(sigma); }
};
}  // namespace weld_profiler
