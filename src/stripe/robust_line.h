#pragma once

#include <array>
#include <cstddef>

namespace weld_profiler
{
/// A straight line through a few points, some of which may be far off: the median of the slopes of all pairs
/// (Theil-Sen).
class RobustLine
{
public:
  static constexpr std::size_t kMostPoints = 8;

  void add(double x, double y);
  /// @return the line's y at x; of a single point its own. Needs one point at least; those beyond kMostPoints are
  /// ignored.
  double at(double x) const;

private:
  std::size_t count_ = 0;
  std::array<double, kMostPoints> x_{}, y_{};
};
}  // namespace weld_profiler
