#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace weld_profiler
{
namespace weld
{
/// Median of what is finite; NaN of nothing. Reorders its copy.
inline double median(std::vector<double> values)
{
  values.erase(std::remove_if(values.begin(), values.end(), [](double v) { return !std::isfinite(v); }), values.end());
  if (values.empty())
    return std::numeric_limits<double>::quiet_NaN();
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  constexpr std::size_t kFew = 24;  // sorting so few is faster than selecting
  if (values.size() <= kFew)
  {
    for (std::size_t i = 1; i < values.size(); ++i)
    {
      const double value = values[i];
      std::size_t at = i;
      for (; at > 0 && values[at - 1] > value; --at)
        values[at] = values[at - 1];
      values[at] = value;
    }
    return values.size() % 2 == 1 ? *middle : 0.5 * (*middle + *(middle - 1));
  }
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1)
    return *middle;
  return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

/// Of normal noise, median absolute value times this is the standard deviation.
constexpr double kMadToSigma = 1.4826;

/// Standard deviation about zero, told from the median absolute value: outliers hardly count. NaN of nothing.
inline double robustSigma(std::vector<double> values)
{
  for (double& value : values)
    value = std::abs(value);
  return kMadToSigma * median(std::move(values));
}

inline double square(double value)
{
  return value * value;
}

/// Where Tukey's biweight ends, in sigmas (95 % efficient).
constexpr double kTukeyReach = 4.685;

/// Tukey's biweight of a residual in units of its scale: 1 at zero, 0 from kTukeyReach on.
inline double tukey(double residual_in_sigmas)
{
  const double t = 1.0 - square(residual_in_sigmas / kTukeyReach);
  return t > 0.0 ? t * t : 0.0;
}
}  // namespace weld
}  // namespace weld_profiler
