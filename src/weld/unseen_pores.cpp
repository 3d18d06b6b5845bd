#include "unseen_pores.h"

#include <algorithm>
#include <cmath>

#include "statistics.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kRound = 0.5, kShallow = 0.25;  // depth of a pore, of its diameter
constexpr double kBlur = 1.3e-4;                 // stripe and fit even out what lies this far to either side [m]
constexpr double kFewest = 6.0;                  // points of a spot
constexpr double kFoot = 2.0 / 3.0;              // of a pore's area lies deep enough, where its bottom just does
constexpr double kWidest = 4e-3;                 // what is wider is no pore [m]
constexpr double kPi = 3.14159265358979323846;
}  // namespace

UnseenPores unseenPores(const ScanGrid& grid, double depth)
{
  const double pitch = std::isfinite(grid.pitch) ? grid.pitch : 0.0;
  // a paraboloid d wide and c d deep is met up to half a pitch beside its bottom: c pitch^2 / d less deep, and blurred
  // by as much as 4 c blur^2 / 3 d
  const double missed = square(pitch) + 4.0 / 3.0 * square(kBlur);
  const double least = std::sqrt(4.0 / kPi * kFewest / kFoot * grid.spacing * pitch);
  const auto widest = [&](double share)
  {
    const double half = 0.5 * depth / share;
    return std::min(kWidest, std::max(least, half + std::sqrt(square(half) + missed)));
  };
  return { widest(kRound), widest(kShallow) };
}
}  // namespace weld
}  // namespace weld_profiler
