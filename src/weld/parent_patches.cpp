#include "parent_patches.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include <Eigen/Dense>

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
constexpr double kFloor = 1e-6;        // of the scale of a plane's residuals [m]

using PatchKey = std::tuple<int, long, long>;

/// Normal of the plane that most patches of a side lie in (Tukey's biweight).
Eigen::Vector3d planeNormal(const std::vector<ParentPatch>& patches, int side)
{
  std::vector<Eigen::Vector3d> places;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const ParentPatch& patch : patches)
  {
    if (patch.side != side)
      continue;
    places.push_back(patch.middle);
    mean += patch.middle;
  }
  if (places.size() < 3)
    return Eigen::Vector3d::UnitZ();
  mean /= static_cast<double>(places.size());
  Eigen::Vector3d plane = Eigen::Vector3d::Zero();  // height and slopes
  std::vector<double> weights(places.size(), 1.0), residuals(places.size());
  constexpr int kSteps = 12;
  for (int step = 0; step < kSteps; ++step)
  {
    Eigen::Matrix3d normal = 1e-12 * Eigen::Matrix3d::Identity();  // a single row of patches has no slope along y
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      const Eigen::Vector3d from = places[i] - mean, basis(1.0, from.x(), from.y());
      normal += weights[i] * basis * basis.transpose();
      right += weights[i] * basis * from.z();
    }
    plane = normal.ldlt().solve(right);
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      const Eigen::Vector3d from = places[i] - mean;
      residuals[i] = from.z() - plane.dot(Eigen::Vector3d(1.0, from.x(), from.y()));
    }
    const double scale = std::max(kFloor, robustSigma(residuals));
    for (std::size_t i = 0; i < places.size(); ++i)
      weights[i] = tukey(residuals[i] / scale);
  }
  return Eigen::Vector3d(-plane.y(), -plane.z(), 1.0).normalized();
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
