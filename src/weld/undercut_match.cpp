#include "undercut_match.h"

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
constexpr double kPatchAlong = 1.2e-3, kPatchAcross = 2.5e-4;  // [m]
constexpr std::size_t kFewPoints = 6;                          // less are no patch
constexpr std::size_t kLeastPatches = 8;
constexpr double kLeastDepth = 3e-5;  // shallower places may as well be rims or scars [m]
constexpr double kOfToe = 2e-4;      // nearer to the face the profile is blurred, by another face before than after [m]
constexpr double kSame = 0.15;       // of a patch's depth: nearer to each other it is what it was
constexpr double kMostMisfit = 0.5;  // of undercuts of which enough stand
constexpr double kLeastSigma = 1e-6;  // of a patch [m]
constexpr double kAlike = 2.0;        // neighbouring patches err alike: this many count as one, square root of

using PatchKey = std::tuple<int, long, long>;

std::vector<std::uint8_t> withoutUndercuts(std::vector<std::uint8_t> labels)
{
  std::replace(labels.begin(), labels.end(), static_cast<std::uint8_t>(WeldLabel::Undercut),
               static_cast<std::uint8_t>(WeldLabel::Base));
  return labels;
}

/// Scatter about what a shift and a turn that are still to be told make of the distances.
double scatterOf(const std::vector<MotionObservation>& observations)
{
  constexpr int kAbsoluteSteps = 10, kTukeySteps = 5;
  std::vector<double> residuals;
  residuals.reserve(observations.size());
  for (const MotionObservation& one : observations)
    residuals.push_back(one.distance);
  for (int i = 0; i < kAbsoluteSteps + kTukeySteps; ++i)
  {
    const double scale = std::max(kLeastSigma, robustSigma(residuals));
    Eigen::Matrix3d normal = 1e-12 * Eigen::Matrix3d::Identity();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < observations.size(); ++k)
    {
      const double off = residuals[k] / scale;
      const double weight = i < kAbsoluteSteps ? 1.0 / std::max(0.1, std::abs(off)) : tukey(off);
      const Eigen::Vector3d& shape = observations[k].shape;
      normal += weight * shape * shape.transpose();
      right -= weight * observations[k].distance * shape;
    }
    const Eigen::Vector3d step = normal.ldlt().solve(right);
    for (std::size_t k = 0; k < observations.size(); ++k)
      residuals[k] = observations[k].distance + observations[k].shape.dot(step);
  }
  return robustSigma(std::move(residuals));
}
}  // namespace

UndercutMatch::UndercutMatch(const ScanGrid& grid, const GridMaps& maps, const PathFrame& path, const Parents& parents)
  : grid_(grid), maps_(maps), path_(path)
{
  const std::vector<float> from_metal = distanceToWeld(grid, withoutUndercuts(maps.labels));
  std::map<PatchKey, Patch> patches;
  double s = 0.0;
  for (std::size_t i = 0; i < grid.z.size(); ++i)
  {
    if (maps.labels[i] != static_cast<std::uint8_t>(WeldLabel::Undercut) || !std::isfinite(maps.target[i]) ||
        !(static_cast<double>(from_metal[i]) > kOfToe))
      continue;
    const PathPlace place = path.locate(static_cast<double>(grid.x[i]), static_cast<double>(grid.y[i]), s);
    s = place.s;
    addPoint(i, patches[{ place.q < 0.0 ? 0 : 1, std::lround(s / kPatchAlong),
                          std::lround(static_cast<double>(from_metal[i]) / kPatchAcross) }]);
  }
  for (auto& entry : patches)
  {
    entry.second.side = std::get<0>(entry.first);
    if (finish(entry.second))
      patches_.push_back(std::move(entry.second));
  }
  if (patches_.size() < kLeastPatches)
    patches_.clear();
  findDirections();
  for (Patch& patch : patches_)
    findSlope(parents.normals[static_cast<std::size_t>(patch.side)], patch);
}

void UndercutMatch::addPoint(std::size_t i, Patch& patch) const
{
  const auto z = static_cast<double>(grid_.z[i]);
  patch.points.push_back(static_cast<std::uint32_t>(i));
  patch.middle += Eigen::Vector3d(static_cast<double>(grid_.x[i]), static_cast<double>(grid_.y[i]), z);
  patch.depth += static_cast<double>(maps_.target[i]) - z;
}

/// Means of sums. False when the patch tells nothing.
bool UndercutMatch::finish(Patch& patch) const
{
  if (patch.points.size() < kFewPoints)
    return false;
  patch.middle /= static_cast<double>(patch.points.size());
  patch.depth /= static_cast<double>(patch.points.size());
  patch.s = path_.locate(patch.middle.x(), patch.middle.y(), 0.0).s;
  return patch.depth > kLeastDepth;
}

/// The path's direction turns evenly along the weld: noise in it would tell a motion along the weld.
void UndercutMatch::findDirections()
{
  Eigen::Matrix2d normal = 1e-12 * Eigen::Matrix2d::Identity();
  Eigen::Matrix2d right = Eigen::Matrix2d::Zero();
  for (const Patch& patch : patches_)
  {
    const Eigen::Vector2d basis(1.0, patch.s);
    normal += basis * basis.transpose();
    right += basis * path_.along(patch.s).transpose();
  }
  const Eigen::Matrix2d line = normal.ldlt().solve(right);
  for (Patch& patch : patches_)
    patch.along = (line.transpose() * Eigen::Vector2d(1.0, patch.s)).normalized();
}

/// Across the weld as it is, along it that of the parent, for the same reason.
void UndercutMatch::findSlope(const Eigen::Vector3d& parent, Patch& patch) const
{
  const Eigen::Vector2d across(patch.along.y(), -patch.along.x());
  const double rise_along = -parent.head<2>().dot(patch.along) / parent.z();
  double width = 1e-15, product = 0.0;
  for (const std::uint32_t i : patch.points)
  {
    const Eigen::Vector2d from(static_cast<double>(grid_.x[i]) - patch.middle.x(),
                               static_cast<double>(grid_.y[i]) - patch.middle.y());
    const double q = from.dot(across);
    width += square(q);
    product += q * (static_cast<double>(grid_.z[i]) - patch.middle.z() - rise_along * from.dot(patch.along));
  }
  patch.slope = rise_along * patch.along + product / width * across;
}

void UndercutMatch::want(std::vector<std::uint8_t>& mask) const
{
  for (const Patch& patch : patches_)
    for (const std::uint32_t i : patch.points)
      mask[i] = 1;
}

double UndercutMatch::rise(const Patch& patch, const std::vector<SurfaceSample>& after) const
{
  double sum = 0.0;
  for (const std::uint32_t i : patch.points)
    sum += static_cast<double>(after[i].z) - static_cast<double>(grid_.z[i]);
  return sum / static_cast<double>(patch.points.size());  // a patch that is not seen as a whole lies elsewhere
}

std::vector<MotionObservation> UndercutMatch::observe(const std::vector<SurfaceSample>& after,
                                                      const Eigen::Vector3d& about) const
{
  std::vector<MotionObservation> observations;
  for (const Patch& patch : patches_)
  {
    const double distance = rise(patch, after);
    if (!std::isfinite(distance))
      continue;
    const Eigen::Vector3d from = patch.middle - about, normal(-patch.slope.x(), -patch.slope.y(), 1.0);
    const Eigen::Vector2d across(patch.along.y(), -patch.along.x());
    MotionObservation one;
    one.jacobian << normal, from.cross(normal);
    one.distance = distance;
    one.common = CommonError::Toes;
    const double steepness = normal.head<2>().dot(across);
    // a shift across, a turn; and walls that look, or were ground, a little deeper all along
    one.shape = { steepness, steepness * from.head<2>().dot(patch.along) / kCommonLength, 1.0 };
    observations.push_back(one);
  }
  if (observations.size() < kLeastPatches)
    return {};
  const double sigma = kAlike * std::max(kLeastSigma, scatterOf(observations));
  for (MotionObservation& one : observations)
    one.sigma = sigma;
  return observations;
}

double UndercutMatch::misfit(const std::vector<SurfaceSample>& after, double alike) const
{
  double sum = 0.0, most = 0.0;
  for (const Patch& patch : patches_)
  {
    const double limit = square(alike * patch.depth), off = square(rise(patch, after));
    sum += off < limit ? off : limit;  // NaN: not seen
    most += limit;
  }
  return most > 0.0 ? sum / most : 1.0;
}

bool UndercutMatch::standing(const std::vector<SurfaceSample>& after) const
{
  return misfit(after, kSame) < kMostMisfit;
}
}  // namespace weld
}  // namespace weld_profiler
