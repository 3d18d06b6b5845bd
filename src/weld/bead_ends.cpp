#include "bead_ends.h"

#include <algorithm>
#include <cmath>

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kStrip = 0.5;  // pitches along the weld: in two of them lies every row
constexpr float kLow = -6e-5F;  // ripples lift all across the weld by less [m]
}  // namespace

bool BeadEnds::isEnding(std::size_t point) const
{
  const double s = sampler_.place(point).s;
  return excess_.on_face[point] != 0 && surface_.isEnding(surface_.nearestSection(s), s);
}

bool BeadEnds::reachedBy(const std::vector<std::size_t>& pit) const
{
  return std::any_of(pit.begin(), pit.end(), [this](std::size_t i) { return isEnding(i); });
}

std::size_t BeadEnds::stripOf(std::size_t point) const
{
  const double along = sampler_.place(point).s - surface_.placeOf(0);
  return static_cast<std::size_t>(std::max(0.0, 1.0 + std::floor(along / (kStrip * grid_.pitch) + 0.5)));
}

void BeadEnds::findMiddles() const
{
  std::vector<std::vector<float>> across;
  for (std::size_t i = 0; i < grid_.z.size(); ++i)
  {
    if (excess_.on_face[i] == 0)
      continue;
    across.resize(std::max(across.size(), stripOf(i) + 1));
    across[stripOf(i)].push_back(excess_.height[i]);
  }
  for (std::vector<float>& strip : across)
  {
    const auto middle = strip.begin() + static_cast<std::ptrdiff_t>(strip.size() / 2);
    std::nth_element(strip.begin(), middle, strip.end());
    middles_.push_back(strip.empty() ? 0.0F : *middle);
  }
}

bool BeadEnds::make(const std::vector<std::size_t>& spot, double clear) const
{
  if (!(grid_.pitch > 0.0) || !reachedBy(spot))
    return false;
  if (middles_.empty())
    findMiddles();
  std::size_t low = 0;
  double top = 0.0;
  for (const std::size_t i : spot)
  {
    const float middle = excess_.on_face[i] != 0 ? middles_[stripOf(i)] : 0.0F;
    const float alike = std::max(0.0F, middle / excess_.height[i]);  // share of what it departs by itself
    low += middle < kLow ? 1 : 0;
    top = std::max(top, static_cast<double>(std::abs(excess_.tolerances[i]) * (1.0F - alike)));
  }
  const bool pit = excess_.height[spot.front()] < 0.0F;
  return (pit && 2 * low > spot.size()) || top < clear;
}
}  // namespace weld
}  // namespace weld_profiler
