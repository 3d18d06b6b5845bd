#include "robust_line.h"

#include <algorithm>

namespace weld_profiler
{
namespace
{
template <std::size_t kSize>
double medianOf(std::array<double, kSize>& values, std::size_t count)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(count / 2);
  std::nth_element(values.begin(), middle, values.begin() + static_cast<std::ptrdiff_t>(count));
  return *middle;
}
}  // namespace

void RobustLine::add(double x, double y)
{
  if (count_ == kMostPoints)
    return;
  x_[count_] = x;
  y_[count_++] = y;
}

double RobustLine::at(double x) const
{
  std::array<double, kMostPoints*(kMostPoints - 1) / 2> slopes{};
  std::size_t pairs = 0;
  for (std::size_t i = 0; i < count_; ++i)
    for (std::size_t j = i + 1; j < count_; ++j)
      if (x_[i] != x_[j])
        slopes[pairs++] = (y_[j] - y_[i]) / (x_[j] - x_[i]);
  const double slope = pairs > 0 ? medianOf(slopes, pairs) : 0.0;
  std::array<double, kMostPoints> there{};
  for (std::size_t i = 0; i < count_; ++i)
    there[i] = y_[i] + slope * (x - x_[i]);
  return medianOf(there, count_);
}
}  // namespace weld_profiler
