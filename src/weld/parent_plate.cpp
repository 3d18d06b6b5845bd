#include "parent_plate.h"

#include <cmath>

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kBetter = 0.8;  // of a plane's scatter: by more than chance

Eigen::Vector2d acrossAt(const WeldPathPoint& place)
{
  return { std::cos(place.yaw), std::sin(place.yaw) };
}
}  // namespace

ParentPlate::ParentPlate(const std::vector<Piece>& pieces, double near, double far)
{
  std::vector<Eigen::Vector3d> seen_from_above, along_path;
  seen_from_above.reserve(2 * pieces.size());
  along_path.reserve(2 * pieces.size());
  for (const Piece& piece : pieces)
  {
    for (const double q : { near, far })
    {
      const Eigen::Vector2d place = Eigen::Vector2d(piece.place.x, piece.place.y) + q * acrossAt(piece.place);
      seen_from_above.emplace_back(place.x(), place.y(), piece.line.at(q));
      along_path.emplace_back(q, piece.place.s, piece.line.at(q));
    }
  }
  plane_ = fitPlane(seen_from_above);
  const Plane following = fitPlane(along_path);
  follows_path_ = following.scatter < kBetter * plane_.scatter;
  if (follows_path_)
    plane_ = following;
}

Line ParentPlate::lineAt(const WeldPathPoint& place) const
{
  if (follows_path_)
    return Line{ plane_.at(0.0, place.s), plane_.slope.x() };
  return Line{ plane_.at(place.x, place.y), plane_.slope.dot(acrossAt(place)) };
}
}  // namespace weld
}  // namespace weld_profiler
