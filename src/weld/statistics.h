#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace weld_profiler
{
namespace weld
{
/// Median of what is finite in [begin, end), which it reorders; NaN of nothing.
inline double medianInPlace(double* begin, double* end)
{
  end = std::remove_if(begin, end, [](double v) { return !std::isfinite(v); });
  const auto size = end - begin;
  if (size == 0)
    return std::numeric_limits<double>::quiet_NaN();
  double* const middle = begin + size / 2;
  constexpr std::ptrdiff_t kFew = 24;  // sorting so few is faster than selecting
  if (size <= kFew)
  {
    for (double* next = begin + 1; next < end; ++next)
    {
      const double value = *next;
      double* at = next;
      for (; at > begin && *(at - 1) > value; --at)
        *at = *(at - 1);
      *at = value;
    }
    return size % 2 == 1 ? *middle : 0.5 * (*middle + *(middle - 1));
  }
  std::nth_element(begin, middle, end);
  return size % 2 == 1 ? *middle : 0.5 * (*middle + *std::max_element(begin, middle));
}

inline double medianInPlace(std::vector<double>& values)
{
  return medianInPlace(values.data(), values.data() + values.size());
}

/// Median of what is finite; NaN of nothing. Reorders its copy.
inline double median(std::vector<double> values)
{
  return medianInPlace(values);
}

/// Of normal noise, median absolute value times this is the standard deviation.
constexpr double kMadToSigma = 1.4826;

/// As robustSigma, of values that it changes and reorders.
inline double robustSigmaInPlace(std::vector<double>& values)
{
  for (double& value : values)
    value = std::abs(value);
  return kMadToSigma * medianInPlace(values);
}

/// Standard deviation about zero, told from the median absolute value: outliers hardly count. NaN of nothing.
inline double robustSigma(std::vector<double> values)
{
  return robustSigmaInPlace(values);
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
