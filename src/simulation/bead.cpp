#include "simulation/bead.h"

#include <algorithm>
#include <cmath>

namespace weld_profiler
{
namespace simulation
{
namespace
{
constexpr double kPi = 3.141592653589793;
constexpr double kRadPerDeg = kPi / 180.0;
constexpr double kCrescent = 0.3;  // ripples trail at the toes by this share of the width
}  // namespace

Bead::Bead(const ScenePlates& plates, const SceneWeld& weld)
  : plates_(plates), weld_(weld), slope_(std::tan(0.5 * plates.angle_deg * kRadPerDeg))
{
  const double yaw = weld.yaw_deg * kRadPerDeg;
  middle_ = { plates.x, weld.start + 0.5 * weld.length };
  tangent_ = { -std::sin(yaw), std::cos(yaw) };
  right_ = { std::cos(yaw), std::sin(yaw) };
}

PathPoint Bead::locate(double x, double y) const
{
  const Eigen::Vector2d offset = Eigen::Vector2d(x, y) - middle_;
  double q = offset.dot(right_);
  double s = offset.dot(tangent_);
  if (weld_.curvature != 0.0)
  {
    const double centre = 1.0 / weld_.curvature;  // of the arc, on the q axis
    const double sign = centre > 0.0 ? 1.0 : -1.0;
    const double across = centre - q;
    q = centre - sign * std::hypot(across, s);
    s = std::atan2(s, sign * across) * std::abs(centre);
  }
  return PathPoint{ q, s + 0.5 * weld_.length };
}

Eigen::Vector2d Bead::place(const PathPoint& point) const
{
  const double s = point.s - 0.5 * weld_.length;
  if (weld_.curvature == 0.0)
    return middle_ + point.q * right_ + s * tangent_;
  const double centre = 1.0 / weld_.curvature;
  const double angle = s * weld_.curvature;
  return middle_ + (centre + (point.q - centre) * std::cos(angle)) * right_ +
         (centre - point.q) * std::sin(angle) * tangent_;
}

double Bead::heading(double s) const
{
  return weld_.yaw_deg * kRadPerDeg - weld_.curvature * (s - 0.5 * weld_.length);
}

double Bead::plateHeight(const PathPoint& point) const
{
  const double side = point.q < 0.0 ? -0.5 : 0.5;
  return plates_.height + side * plates_.misalignment + slope_ * std::abs(point.q);
}

double Bead::rise(double s) const
{
  const double inside = std::min(s, weld_.length - s);
  if (weld_.width <= 0.0 || inside <= 0.0)
    return 0.0;
  return weld_.end_length > 0.0 ? std::min(1.0, inside / weld_.end_length) : 1.0;
}

double Bead::halfWidth(double s) const
{
  const double t = rise(s);
  return 0.5 * weld_.width * std::sqrt(t * (2.0 - t));  // an ellipse seen from above
}

double Bead::face(const PathPoint& point, double half) const
{
  const double left = plateHeight(PathPoint{ -half, point.s });
  const double right = plateHeight(PathPoint{ half, point.s });
  const double chord = 0.5 * (left + right) + 0.5 * (right - left) * point.q / half;
  const double t = rise(point.s);
  const double crest = weld_.reinforcement * t * (2.0 - t);
  double above = 0.0;
  if (crest > 0.0)
  {
    const double radius = 0.5 * (half * half + crest * crest) / crest;
    above = std::sqrt(radius * radius - point.q * point.q) - (radius - crest);
  }
  if (weld_.ripple_height > 0.0)
  {
    const double share = point.q * point.q / (half * half);
    const double phase = (point.s + kCrescent * weld_.width * share) / weld_.ripple_pitch;
    above += 0.5 * weld_.ripple_height * t * (1.0 - share) * std::sin(2.0 * kPi * phase);
  }
  return chord + above;
}

double Bead::undercut(const PathPoint& point, double outside) const
{
  const double depth = point.q < 0.0 ? weld_.undercut_left : weld_.undercut_right;
  if (depth <= 0.0 || outside >= weld_.undercut_width)
    return 0.0;
  const double wave = std::sin(kPi * std::sqrt(outside / weld_.undercut_width));  // deepest near the toe
  return depth * rise(point.s) * wave * wave;
}

double Bead::height(const PathPoint& point) const
{
  const double half = halfWidth(point.s);
  if (half <= 0.0)
    return plateHeight(point);
  const double outside = std::abs(point.q) - half;
  if (outside < 0.0)
    return face(point, half);
  return plateHeight(point) - undercut(point, outside);
}
}  // namespace simulation
}  // namespace weld_profiler
