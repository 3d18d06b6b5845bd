#pragma once

#include <array>
#include <cstddef>

namespace weld_profiler
{
/// The cubic spline that passes through every knot, straight at its ends: the paper's interpolation of breakpoints, to
/// the letter. Poor for: noisy knots, between which it swings.
class NaturalSpline
{
public:
  static constexpr std::size_t kMostKnots = 32;

  /// @param x  strictly rising.
  void fit(const std::array<double, kMostKnots>& x, const std::array<double, kMostKnots>& y, std::size_t count);
  double at(double x) const;

private:
  std::size_t count_ = 0;
  std::array<double, kMostKnots> x_{}, y_{}, curvature_{};
};
}  // namespace weld_profiler
