#include "parent_patches.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "plane_fit.h"
#include "statistics.h"
#include "weld_profiler/weld/weld_result.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kPatch = 1.2e-3;      // [m], longer than neighbouring points of a stripe err alike
constexpr std::size_t kFewPoints = 6;  // less are no patch

using PatchKey = std::tuple<int, long, long>;

/// Normal of the plane that most patches of a side lie in.
Eigen::Vector3d planeNormal(const std::vector<ParentPatch>& patches, int side)
{
  std::vector<Eigen::Vector3d> places;
  for (const ParentPatch& patch : patches)
  {
    if (patch.side == side)
      places.push_back(patch.middle);
  }
  if (places.size() < 3)
    return Eigen::Vector3d::UnitZ();
  const Plane plane = fitPlane(places);
  return Eigen::Vector3d(-plane.slope.x(), -plane.slope.y(), 1.0).normalized();
}
}  // namespace

Parents findParents(const ScanGrid& grid, const PathFrame& path, const ParentChoice& choice)
{
  std::map<PatchKey, ParentPatch> patches;
  double s = 0.0;
  for (std::size_t i = 0; i < grid.z.size(); ++i)
  {
    if (choice.labels[i] != static_cast<std::uint8_t>(WeldLabel::Base) || !(choice.distance[i] > choice.beyond))
      continue;
    const auto x = static_cast<double>(grid.x[i]), y = static_cast<double>(grid.y[i]);
    const PathPlace place = path.locate(x, y, s);
    s = place.s;
    if (std::abs(place.q) < choice.half_width)
      continue;
    const int side = place.q < 0.0 ? 0 : 1;
    ParentPatch& patch = patches[{ side, std::lround(y / kPatch), std::lround(x / kPatch) }];
    patch.side = side;
    patch.points.push_back(static_cast<std::uint32_t>(i));
    patch.middle += Eigen::Vector3d(x, y, static_cast<double>(grid.z[i]));
  }
  Parents parents;
  for (auto& entry : patches)
  {
    ParentPatch& patch = entry.second;
    if (patch.points.size() < kFewPoints)
      continue;
    patch.middle /= static_cast<double>(patch.points.size());
    ++parents.count[static_cast<std::size_t>(patch.side)];
    parents.patches.push_back(std::move(patch));
  }
  for (const int side : { 0, 1 })
    parents.normals[static_cast<std::size_t>(side)] = planeNormal(parents.patches, side);
  return parents;
}

double meanRise(const ScanGrid& grid, const ParentPatch& patch, const std::vector<SurfaceSample>& surface)
{
  double sum = 0.0;
  std::size_t known = 0;
  for (const std::uint32_t i : patch.points)
  {
    if (!std::isfinite(surface[i].z))
      continue;
    sum += static_cast<double>(surface[i].z) - static_cast<double>(grid.z[i]);
    ++known;
  }
  return known >= kFewPoints && 2 * known >= patch.points.size() ? sum / static_cast<double>(known) : kNaN;
}
}  // namespace weld
}  // namespace weld_profiler
