#include "weld/compare_spots.h"

#include <algorithm>
#include <cmath>

namespace weld_profiler
{
namespace weld_accuracy
{
namespace
{
constexpr double kAround = 1e-4;  // [m]

bool sameKind(const WeldSpot& told, const TrueSpot& truth)
{
  return (told.kind == WeldSpot::Kind::Pore) == (truth.kind == TrueSpot::Kind::Pore);
}

double apart(const WeldSpot& told, const TrueSpot& truth)
{
  return std::hypot(told.x - truth.position[0], told.y - truth.position[1]);
}

std::size_t spotClass(double diameter)
{
  std::size_t at = 0;
  while (at + 1 < kSpotClasses.size() && diameter >= kSpotClasses[at + 1])
    ++at;
  return at;
}

/// Whether the scan's rows pass over all of a spot.
bool liesInScan(const TrueSpot& spot, const Scan& scan)
{
  const double radius = 0.5 * spot.diameter;
  const auto sees = [&](double y)
  {
    const auto row = std::min_element(scan.rows.begin(), scan.rows.end(),
                                      [y](const Profile& a, const Profile& b)
                                      { return std::abs(a.stage - y) < std::abs(b.stage - y); });
    const auto& points = row->points;
    return !points.empty() && points.front().x < spot.position[0] - radius &&
           points.back().x > spot.position[0] + radius;
  };
  const double first = scan.rows.front().stage, last = scan.rows.back().stage;
  const double from = spot.position[1] - radius, to = spot.position[1] + radius;
  return from > std::min(first, last) && to < std::max(first, last) && sees(from) && sees(to);
}
}  // namespace

Spots compareSpots(const MeasuredWeld& weld)
{
  Spots spots;
  const std::vector<TrueSpot> truths = weld.simulated.spots();
  for (const TrueSpot& truth : truths)
  {
    if (!liesInScan(truth, weld.scan))
      continue;
    SpotClass& of = spots.classes[spotClass(truth.diameter)];
    ++of.inside;
    const auto told =
        std::find_if(weld.result.spots.begin(), weld.result.spots.end(),
                     [&](const WeldSpot& spot)
                     { return sameKind(spot, truth) && apart(spot, truth) < 0.5 * truth.diameter + kAround; });
    if (told == weld.result.spots.end())
      continue;
    ++of.found;
    of.diameter += std::abs(told->diameter.value - truth.diameter);
    of.height += std::abs(told->height.value - truth.height);
  }
  for (const WeldSpot& told : weld.result.spots)
  {
    const bool real = std::any_of(truths.begin(), truths.end(),
                                  [&](const TrueSpot& truth) {
                                    return sameKind(told, truth) &&
                                           apart(told, truth) < 0.5 * (truth.diameter + told.diameter.value) + kAround;
                                  });
    if (!real)
      ++(told.kind == WeldSpot::Kind::Pore ? spots.false_pores : spots.false_spatter);
  }
  return spots;
}
}  // namespace weld_accuracy
}  // namespace weld_profiler
