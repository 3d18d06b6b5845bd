#include "natural_spline.h"

namespace weld_profiler
{
void NaturalSpline::fit(const std::array<double, kMostKnots>& x, const std::array<double, kMostKnots>& y,
                        std::size_t count)
{
  x_ = x;
  y_ = y;
  count_ = count;
  // Continuous slopes give a tridiagonal system for the curvatures, solved by elimination and substitution.
  std::array<double, kMostKnots> share{};
  curvature_.fill(0.0);
  for (std::size_t i = 1; i + 1 < count; ++i)
  {
    const double left = x[i] - x[i - 1];
    const double right = x[i + 1] - x[i];
    const double bend = 6.0 * ((y[i + 1] - y[i]) / right - (y[i] - y[i - 1]) / left);
    const double pivot = 2.0 * (left + right) - left * share[i - 1];
    share[i] = right / pivot;
    curvature_[i] = (bend - left * curvature_[i - 1]) / pivot;
  }
  for (std::size_t i = count - 1; i-- > 1;)
    curvature_[i] -= share[i] * curvature_[i + 1];
}

double NaturalSpline::at(double x) const
{
  std::size_t i = 1;
  while (i + 1 < count_ && x > x_[i])
    ++i;
  const double width = x_[i] - x_[i - 1];
  const double a = (x_[i] - x) / width;
  const double b = 1.0 - a;
  return a * y_[i - 1] + b * y_[i] +
         ((a * a * a - a) * curvature_[i - 1] + (b * b * b - b) * curvature_[i]) * width * width / 6.0;
}
}  // namespace weld_profiler
