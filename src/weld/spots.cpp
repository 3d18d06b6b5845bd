#include "spots.h"

#include <algorithm>
#include <cmath>

#include "stray_excess.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kPi = 3.14159265358979323846;
constexpr std::size_t kFewest = 6;    // points of a spot
constexpr double kWidest = 4e-3;      // [m]
constexpr double kClear = 1.5;        // tolerances that a spot's top must reach
constexpr double kRim = 1.3e-4;       // around a stray the surface is blurred with it [m]
constexpr double kOfTolerance = 0.5;  // the foot of a stray reaches down to this share of the tolerance

class StraySearch
{
public:
  StraySearch(const ScanGrid& grid, const SectionSampler& sampler, const SeamSurface& surface)
    : grid_(grid), sampler_(sampler)
  {
    StrayExcess found = strayExcess(grid, sampler, surface);
    excess_ = std::move(found.tolerances);
    height_ = std::move(found.height);
    on_face_ = std::move(found.on_face);
  }

  Strays operator()()
  {
    Strays strays;
    strays.kind.assign(grid_.z.size(), Stray::None);
    strays.masked.assign(grid_.z.size(), 0);
    seen_.assign(grid_.z.size(), 0);
    for (std::size_t i = 0; i < grid_.z.size(); ++i)
    {
      if (seen_[i] == 0 && std::abs(excess_[i]) > 1.0F)
        takeSpot(i, strays);
    }
    std::sort(strays.spots.begin(), strays.spots.end(), [](const WeldSpot& a, const WeldSpot& b) { return a.s < b.s; });
    return strays;
  }

private:
  /// Points that hang together with `start`, on the same side of the surface.
  std::vector<std::size_t> connected(std::size_t start)
  {
    const bool above = excess_[start] > 0.0F;
    std::vector<std::size_t> spot{ start };
    seen_[start] = 1;
    for (std::size_t next = 0; next < spot.size(); ++next)
    {
      const int row = static_cast<int>(spot[next] / static_cast<std::size_t>(grid_.cells));
      const int column = static_cast<int>(spot[next] % static_cast<std::size_t>(grid_.cells));
      for (int r = std::max(0, row - 1); r <= std::min(grid_.rows - 1, row + 1); ++r)
      {
        for (int c = std::max(0, column - 2); c <= std::min(grid_.cells - 1, column + 2); ++c)
        {
          const std::size_t i = grid_.at(r, c);
          if (seen_[i] != 0 || std::abs(excess_[i]) < kOfTolerance || (excess_[i] > 0.0F) != above)
            continue;
          seen_[i] = 1;
          spot.push_back(i);
        }
      }
    }
    return spot;
  }

  void takeSpot(std::size_t start, Strays& strays)
  {
    const std::vector<std::size_t> points = connected(start);
    WeldSpot spot;
    bool on_face = false;
    double top = 0.0, least_x = INFINITY, most_x = -INFINITY, least_y = INFINITY, most_y = -INFINITY;
    for (const std::size_t i : points)
    {
      const double x = static_cast<double>(grid_.x[i]), y = static_cast<double>(grid_.y[i]);
      least_x = std::min(least_x, x), most_x = std::max(most_x, x);
      least_y = std::min(least_y, y), most_y = std::max(most_y, y);
      if (std::abs(excess_[i]) < top)
        continue;
      top = std::abs(static_cast<double>(excess_[i]));
      spot.x = x, spot.y = y, spot.z = static_cast<double>(grid_.z[i]);
      spot.s = sampler_.place(i).s;
      on_face = on_face_[i] != 0;
      spot.height = Quantity{ static_cast<double>(height_[i]), static_cast<double>(grid_.sigma[i]) };
    }
    if (points.size() < kFewest || top < kClear)
      return;
    // what lies below a plate is no pore of the weld
    const bool pit = spot.height.value < 0.0 && !on_face;
    const bool foreign = pit || std::max(most_x - least_x, most_y - least_y) > kWidest;
    const double cell = grid_.spacing * (std::isfinite(grid_.pitch) ? grid_.pitch : grid_.spacing);
    const double diameter = std::sqrt(4.0 / kPi * cell * static_cast<double>(points.size()));
    spot.diameter = Quantity{ diameter, 0.5 * std::hypot(grid_.spacing, grid_.pitch) };
    spot.kind = spot.height.value > 0.0 ? WeldSpot::Kind::Spatter : WeldSpot::Kind::Pore;
    const Stray kind = foreign ? Stray::Foreign : spot.kind == WeldSpot::Kind::Spatter ? Stray::Spatter : Stray::Pore;
    if (!foreign)
      strays.spots.push_back(spot);
    for (const std::size_t i : points)
    {
      strays.kind[i] = kind;
      maskAround(i, strays.masked);
    }
  }

  void maskAround(std::size_t point, std::vector<std::uint8_t>& masked) const
  {
    const int row = static_cast<int>(point / static_cast<std::size_t>(grid_.cells));
    const int column = static_cast<int>(point % static_cast<std::size_t>(grid_.cells));
    const int columns = static_cast<int>(std::ceil(kRim / grid_.spacing));
    const int rows = grid_.pitch > 0.0 ? static_cast<int>(std::lround(kRim / grid_.pitch)) : 0;
    for (int r = std::max(0, row - rows); r <= std::min(grid_.rows - 1, row + rows); ++r)
      for (int c = std::max(0, column - columns); c <= std::min(grid_.cells - 1, column + columns); ++c)
        masked[grid_.at(r, c)] = 1;
  }

  const ScanGrid& grid_;
  const SectionSampler& sampler_;
  std::vector<float> excess_;  ///< departure over tolerance
  std::vector<float> height_;  ///< departure [m]
  std::vector<std::uint8_t> on_face_;
  std::vector<std::uint8_t> seen_;
};
}  // namespace

Strays findStrays(const ScanGrid& grid, const SectionSampler& sampler, const SeamSurface& surface)
{
  return StraySearch(grid, sampler, surface)();
}
}  // namespace weld
}  // namespace weld_profiler
