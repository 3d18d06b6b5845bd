#include "toe_sway.h"

#include <algorithm>
#include <cmath>

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kSteady = 0.15;  // slope over the path that a steady weld's toe does not exceed
}

std::vector<double> toeSway(const SeamSections& sections, Side side, double reach)
{
  const std::vector<double>& places = sections.places();
  std::vector<double> sway(sections.size(), 0.0);
  for (std::size_t k = 0; k < sections.size(); ++k)
  {
    const double here = sections.mappedToe(k, side);
    for (std::size_t j = 0; j < sections.size(); ++j)
    {
      const double moved = std::abs(sections.mappedToe(j, side) - here);
      if (std::abs(places[j] - places[k]) < reach && moved > kSteady * reach)
        sway[k] = std::max(sway[k], moved);
    }
  }
  return sway;
}
}  // namespace weld
}  // namespace weld_profiler
