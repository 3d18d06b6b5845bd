#include "simulation/shader.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace weld_profiler
{
namespace simulation
{
namespace
{
constexpr double kRadPerDeg = 0.017453292519943295;
constexpr double kProbe = 1e-6;        // step of the projection's derivative [m]
constexpr double kThinnest = 0.2;      // of the sheet in the image [px]
constexpr double kThickest = 15.0;     // a surface seen edge-on would smear it without end [px]
constexpr double kBounceStep = 50e-6;  // of the search for where mirrored light arrives [m]
constexpr double kBouncePx = 12.0;     // neighbours that arrive farther apart make no line [px]

Eigen::Vector3d normalOf(const Eigen::Vector2d& slope)
{
  return Eigen::Vector3d(-slope.x(), -slope.y(), 1.0).normalized();
}
}  // namespace

Shader::Shader(const SceneParams& scene, const Surface& surface, const Rig& rig, const RigPose& reference)
  : surface_(surface), laser_(scene.laser)
{
  const SheetCut cut(surface, rig, reference);
  CutPoint point;  // the flat plate under the optical axis
  point.position = { 0.0, reference.sheet_distance / reference.sheet_normal.y(), 0.0 };
  const Footprint flat = footprint(cut, point, Eigen::Vector2d::Zero());
  const double sheet_px = std::sqrt(laser_.sigma_px * laser_.sigma_px - laser_.lens_sigma_px * laser_.lens_sigma_px);
  sheet_sigma_ = sheet_px * std::abs(flat.sheet_rate);
  gain_ = laser_.sigma_px / sheet_px;
  across_scale_ = std::hypot(flat.x_rate, flat.y_rate);
  const double forward = cut.project(point.position + Eigen::Vector3d(kProbe, 0.0, 0.0)).cell;
  const double back = cut.project(point.position - Eigen::Vector3d(kProbe, 0.0, 0.0)).cell;
  along_scale_ = 2.0 * kProbe / std::abs(forward - back);
}

Shader::Footprint Shader::footprint(const SheetCut& cut, const CutPoint& point, const Eigen::Vector2d& slope) const
{
  // Jacobian of (cell, across) over the surface's (x, y), solved for a step of (0, 1)
  const auto derivative = [&](double dx, double dy)
  {
    const Eigen::Vector3d step(dx, dy, slope.x() * dx + slope.y() * dy);
    const StripePixel after = cut.project(point.position + step);
    const StripePixel before = cut.project(point.position - step);
    return Eigen::Vector2d((after.cell - before.cell) / (2.0 * kProbe),
                           (after.across - before.across) / (2.0 * kProbe));
  };
  const Eigen::Vector2d by_x = derivative(kProbe, 0.0);
  const Eigen::Vector2d by_y = derivative(0.0, kProbe);
  const double determinant = by_x.x() * by_y.y() - by_x.y() * by_y.x();
  constexpr double kEdgeOn = 1.0;  // [px^2/m^2]; a flat plate has 5e8
  if (std::abs(determinant) < kEdgeOn)
    return Footprint{ 0.0, 0.0, 0.0 };
  Footprint result{};
  result.x_rate = -by_y.x() / determinant;
  result.y_rate = by_x.x() / determinant;
  const Eigen::Vector3d move(result.x_rate, result.y_rate, slope.x() * result.x_rate + slope.y() * result.y_rate);
  result.sheet_rate = cut.pose().sheet_normal.dot(move);
  return result;
}

double Shader::brightness(const RigPose& pose, const Eigen::Vector3d& position, const Eigen::Vector3d& normal) const
{
  const Eigen::Vector3d light = (pose.emitter - position).normalized();
  const double cosine = std::max(0.0, normal.dot(light));
  double result = surface_.reflectance(position.x(), position.y()) * (1.0 + laser_.shading * (cosine - 1.0));
  if (laser_.specular > 0.0)
  {
    const Eigen::Vector3d half = (light + (pose.camera - position).normalized()).normalized();
    const double angle = std::acos(std::min(1.0, normal.dot(half))) / (laser_.specular_width_deg * kRadPerDeg);
    result += laser_.specular * std::exp(-0.5 * angle * angle);
  }
  return result;
}

LitPoint Shader::light(const SheetCut& cut, const CutPoint& point, const Eigen::Vector2d& slope) const
{
  const Footprint here = footprint(cut, point, slope);
  LitPoint lit;
  lit.pixel = point.pixel;
  lit.sheet_sigma = std::min(kThickest, std::max(kThinnest, sheet_sigma_ / std::max(1e-9, std::abs(here.sheet_rate))));
  lit.amplitude = laser_.peak * gain_ * brightness(cut.pose(), point.position, normalOf(slope));
  lit.x = point.position.x();
  lit.y = point.position.y();
  lit.x_rate = here.x_rate;
  lit.y_rate = here.y_rate;
  return lit;
}

LitLine Shader::shade(const SheetCut& cut, const std::vector<CutPoint>& points) const
{
  LitLine line;
  line.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const CutPoint& point = points[i];
    if (!point.lit || !point.seen)
      continue;
    LitPoint lit = light(cut, point, surface_.slope(point.position.x(), point.position.y()));
    lit.joined = point.joined && i + 1 < points.size() && points[i + 1].lit && points[i + 1].seen;
    line.push_back(lit);
  }
  return line;
}

bool Shader::bounce(const SheetCut& cut, const CutPoint& from, LitPoint& arrived) const
{
  const Eigen::Vector3d normal = normalOf(surface_.slope(from.position.x(), from.position.y()));
  const Eigen::Vector3d laser = (from.position - cut.pose().emitter).normalized();
  const Eigen::Vector3d away = laser - 2.0 * laser.dot(normal) * normal;
  const double distance = surface_.firstHit(from.position, away, kBounceStep);
  if (distance < 0.0)
    return false;
  CutPoint target;
  target.position = from.position + distance * away;
  target.position.z() = surface_.height(target.position.x(), target.position.y());
  const Eigen::Vector3d view = (cut.pose().camera - target.position).normalized();
  if (surface_.firstHit(target.position, view, kBounceStep) >= 0.0)
    return false;
  target.pixel = cut.project(target.position);
  arrived = light(cut, target, surface_.slope(target.position.x(), target.position.y()));
  return true;
}

LitLine Shader::mirror(const SheetCut& cut, const std::vector<CutPoint>& points) const
{
  LitLine line;
  bool before = false;  // the last point's light arrived somewhere too
  for (const CutPoint& point : points)
  {
    LitPoint arrived;
    const bool hit = point.lit && bounce(cut, point, arrived);
    if (hit && before)
      line.back().joined = std::abs(arrived.pixel.cell - line.back().pixel.cell) < kBouncePx &&
                           std::abs(arrived.pixel.across - line.back().pixel.across) < kBouncePx;
    if (hit)
      line.push_back(arrived);
    before = hit && point.joined;
  }
  return line;
}
}  // namespace simulation
}  // namespace weld_profiler
