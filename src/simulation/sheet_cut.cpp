#include "simulation/sheet_cut.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace weld_profiler
{
namespace simulation
{
namespace
{
constexpr double kMarginPx = 12.0;     // the cut goes on this far outside the image, for what the lens spreads inward
constexpr double kSpacingPx = 0.5;     // of the points
constexpr double kWallSlope = 8.0;     // steeper than this (83 deg) between neighbours is a wall
constexpr double kShadowStep = 25e-6;  // of the search along a viewing ray [m]
constexpr double kGrazing = 1e-9;      // lit points may differ by this in the tangent of the laser's fan
}  // namespace

SheetCut::SheetCut(const Surface& surface, const Rig& rig, const RigPose& pose)
  : surface_(surface), rig_(rig), pose_(pose), swapped_(rig.direction() == Direction::AlongV)
{
  cells_ = swapped_ ? rig.camera().height() : rig.camera().width();
  across_pixels_ = swapped_ ? rig.camera().width() : rig.camera().height();
  ahead_ = Eigen::Vector3d(pose.sheet_normal.x(), pose.sheet_normal.y(), 0.0);
  along_ = Eigen::Vector3d(ahead_.y(), -ahead_.x(), 0.0).normalized();
  const Eigen::Vector3d foot(0.0, pose.sheet_distance / pose.sheet_normal.y(), 0.0);
  if (project(foot + 1e-3 * along_).cell < project(foot - 1e-3 * along_).cell)
    along_ = -along_;  // t rises with the cells
  first_t_ = 1e9;
  last_t_ = -1e9;
  for (const double z : { surface.lowest(), surface.highest() })
    for (const double cell : { -kMarginPx, cells_ - 1 + kMarginPx })
    {
      CutPoint middle;
      middle.position = foot + Eigen::Vector3d(0.0, 0.0, z);
      const double across = project(middle.position).across;
      const double t = range(raw(StripePixel{ cell, across }), z);
      first_t_ = std::min(first_t_, t);
      last_t_ = std::max(last_t_, t);
    }
}

/// t of the point at height z that a pixel sees.
double SheetCut::range(const Eigen::Vector2d& pixel, double z) const
{
  const Eigen::Vector3d direction = pose_.rotation * rig_.camera().ray(pixel);
  const Eigen::Vector3d point = pose_.camera + direction * ((z - pose_.camera.z()) / direction.z());
  return point.dot(along_);
}

StripePixel SheetCut::project(const Eigen::Vector3d& fixed) const
{
  const Eigen::Vector2d pixel = rig_.camera().project(pose_.toCamera(fixed));
  return swapped_ ? StripePixel{ pixel.y(), pixel.x() } : StripePixel{ pixel.x(), pixel.y() };
}

Eigen::Vector2d SheetCut::raw(const StripePixel& pixel) const
{
  return swapped_ ? Eigen::Vector2d(pixel.across, pixel.cell) : Eigen::Vector2d(pixel.cell, pixel.across);
}

bool SheetCut::at(double t, CutPoint& point) const
{
  constexpr int kIterations = 12;     // contracts by sheet tilt times slope each time; an upright sheet needs one
  constexpr double kSettled = 1e-10;  // [m]
  constexpr double kUpright = 1e-9;
  const double squared = ahead_.squaredNorm();
  double z = point.position.z();
  for (int i = 0; i < kIterations; ++i)
  {
    const double reach = (pose_.sheet_distance - pose_.sheet_normal.z() * z) / squared;
    point.position = t * along_ + reach * ahead_;
    point.position.z() = z;
    const double height = surface_.height(point.position.x(), point.position.y());
    const bool settled = std::abs(height - z) < kSettled || std::abs(pose_.sheet_normal.z()) < kUpright;
    point.position.z() = z = height;
    if (!settled)
      continue;
    point.t = t;
    point.pixel = project(point.position);
    return true;
  }
  return false;
}

std::vector<CutPoint> SheetCut::trace() const
{
  const int count = static_cast<int>((cells_ + 2.0 * kMarginPx) / kSpacingPx) + 1;
  const double step = (last_t_ - first_t_) / (count - 1);
  std::vector<CutPoint> points;
  points.reserve(static_cast<std::size_t>(count));
  int last = -2;  // index of the last point found
  for (int i = 0; i < count; ++i)
  {
    CutPoint point;
    if (!points.empty())
      point.position.z() = points.back().position.z();
    if (!at(first_t_ + i * step, point))
      continue;
    if (last == i - 1)
      points.back().joined = std::abs(point.position.z() - points.back().position.z()) < kWallSlope * step;
    last = i;
    points.push_back(point);
  }
  light(points);
  look(points);
  return points;
}

void SheetCut::light(std::vector<CutPoint>& points) const
{
  // The fan's tangent rises along a lit profile; where it falls back, something nearer the emitter throws a shadow.
  const Eigen::Vector3d down = pose_.sheet_normal.cross(along_).normalized();
  std::vector<double> tangent(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Eigen::Vector3d ray = points[i].position - pose_.emitter;
    tangent[i] = ray.dot(along_) / std::abs(ray.dot(down));
  }
  const auto foot = static_cast<std::size_t>(
      std::min_element(tangent.begin(), tangent.end(), [](double a, double b) { return std::abs(a) < std::abs(b); }) -
      tangent.begin());
  double reached = -1e9;
  for (std::size_t i = foot; i < points.size(); ++i)
  {
    points[i].lit = tangent[i] >= reached - kGrazing;
    reached = std::max(reached, tangent[i]);
  }
  reached = 1e9;
  for (std::size_t i = foot + 1; i-- > 0;)
  {
    points[i].lit = tangent[i] <= reached + kGrazing;
    reached = std::min(reached, tangent[i]);
  }
}

void SheetCut::look(std::vector<CutPoint>& points) const
{
  for (CutPoint& point : points)
  {
    const Eigen::Vector3d view = (pose_.camera - point.position).normalized();
    point.seen = surface_.firstHit(point.position, view, kShadowStep) < 0.0;
  }
}
}  // namespace simulation
}  // namespace weld_profiler
