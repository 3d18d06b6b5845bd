#include "path_frame.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
namespace weld
{
PathFrame::PathFrame(const std::vector<WeldPathPoint>& path)
{
  if (path.size() < 2)
    throw PreconditionError("a weld's path has " + std::to_string(path.size()) + " points, must be two or more");
  for (const WeldPathPoint& point : path)
  {
    if (!std::isfinite(point.s) || !std::isfinite(point.x) || !std::isfinite(point.y) || !std::isfinite(point.yaw))
      throw PreconditionError("point " + std::to_string(stations_.size()) + " of the weld's path is not finite");
    if (!stations_.empty() && !(point.s > stations_.back().s))
      throw PreconditionError("s of the weld's path must rise, but does not at point " +
                              std::to_string(stations_.size()));
    stations_.push_back({ point.s, { point.x, point.y }, { -std::sin(point.yaw), std::cos(point.yaw) } });
  }
}

PathFrame::Spot PathFrame::spot(double s) const
{
  const Station& first = stations_.front();
  const Station& last = stations_.back();
  if (s <= first.s)
    return { first.place + (s - first.s) * first.along, first.along };
  if (s >= last.s)
    return { last.place + (s - last.s) * last.along, last.along };
  const auto after = std::upper_bound(stations_.begin(), stations_.end(), s,
                                      [](double value, const Station& station) { return value < station.s; });
  const Station& a = *(after - 1);
  const Station& b = *after;
  // cubic Hermite: sections may lie millimetres apart on a curved path
  const double step = b.s - a.s, t = (s - a.s) / step, u = 1.0 - t;
  const Eigen::Vector2d place = u * u * (1.0 + 2.0 * t) * a.place + t * u * u * step * a.along +
                                t * t * (3.0 - 2.0 * t) * b.place - t * t * u * step * b.along;
  return { place, (u * a.along + t * b.along).normalized() };
}

Eigen::Vector2d PathFrame::at(const PathPlace& place) const
{
  const Spot here = spot(place.s);
  return here.place + place.q * Eigen::Vector2d(here.along.y(), -here.along.x());
}

Eigen::Vector2d PathFrame::along(double s) const
{
  return spot(s).along;
}

PathPlace PathFrame::locate(double x, double y, double near_s) const
{
  constexpr int kSteps = 6;
  constexpr double kEnough = 1e-7;  // [m]
  PathPlace place{ 0.0, near_s };
  for (int i = 0; i < kSteps; ++i)
  {
    const Spot here = spot(place.s);
    const Eigen::Vector2d from = Eigen::Vector2d(x, y) - here.place;
    const double ahead = here.along.dot(from);
    place.q = from.x() * here.along.y() - from.y() * here.along.x();
    place.s += ahead;
    if (std::abs(ahead) < kEnough)
      break;
  }
  return place;
}
}  // namespace weld
}  // namespace weld_profiler
