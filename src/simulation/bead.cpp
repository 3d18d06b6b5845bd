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

/// A circle's arc over a chord of twice `half`, `crest` high in the middle.
double arc(double q, double half, double crest)
{
  const double radius = 0.5 * (half * half + crest * crest) / crest;
  return std::sqrt(radius * radius - q * q) - (radius - crest);
}
}  // namespace

Bead::Bead(const ScenePlates& plates, const SceneWeld& weld, const SceneSecondBead& second)
  : plates_(plates),
    weld_(weld),
    second_(second),
    warp_(weld.crest_offset / (1.0 - weld.crest_offset * weld.crest_offset)),
    slope_left_(std::tan((0.5 * plates.angle_deg - plates.tilt_deg) * kRadPerDeg)),
    slope_right_(std::tan((0.5 * plates.angle_deg + plates.tilt_deg) * kRadPerDeg))
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
  const bool left = point.q < 0.0;
  const double slope = left ? slope_left_ : slope_right_;
  return plates_.height + (left ? -0.5 : 0.5) * plates_.misalignment + slope * std::abs(point.q);
}

double Bead::steepest() const
{
  return std::max(std::abs(slope_left_), std::abs(slope_right_));
}

Bead::Run Bead::run(double s) const
{
  if (weld_.tack_length <= 0.0)
    return Run{ s, weld_.length - s };
  const double period = weld_.tack_length + weld_.tack_gap;
  const double from_start = s < 0.0 ? s : std::fmod(s, period);
  return Run{ from_start, std::min(weld_.tack_length - from_start, weld_.length - s) };
}

double Bead::rise(const Run& run) const
{
  const double inside = std::min(run.from_start, run.to_end);
  if (inside <= 0.0)
    return 0.0;
  return weld_.end_length > 0.0 ? std::min(1.0, inside / weld_.end_length) : 1.0;
}

double Bead::halfWidth(double s) const
{
  const double t = rise(run(s));
  return 0.5 * weld_.width * std::sqrt(t * (2.0 - t));  // an ellipse seen from above
}

double Bead::crater(const Run& run) const
{
  const auto pit = [this](double depth, double from_end)
  {
    const double wave = from_end < weld_.crater_length ? std::sin(kPi * from_end / weld_.crater_length) : 0.0;
    return depth * wave * wave;
  };
  return pit(weld_.crater_start, run.from_start) + pit(weld_.crater_end, run.to_end);
}

double Bead::chord(const PathPoint& point, double half) const
{
  const double left = plateHeight(PathPoint{ -half, point.s });
  const double right = plateHeight(PathPoint{ half, point.s });
  return 0.5 * (left + right) + 0.5 * (right - left) * point.q / half;
}

double Bead::face(const PathPoint& point, double half) const
{
  const Run here = run(point.s);
  const double t = rise(here);
  const double crest = weld_.reinforcement * t * (2.0 - t);
  double q = point.q;
  if (warp_ != 0.0)
    q -= warp_ * (half - q * q / half);
  double above = 0.0;
  if (crest > 0.0)
    above = arc(q, half, crest);
  else if (crest < 0.0)
    above = -arc(q, half, -crest);
  const double share = q * q / (half * half);
  if (weld_.ripple_height > 0.0)
  {
    const double phase = (point.s + kCrescent * weld_.width * share) / weld_.ripple_pitch;
    above += 0.5 * weld_.ripple_height * t * (1.0 - share) * std::sin(2.0 * kPi * phase);
  }
  if (weld_.crater_start > 0.0 || weld_.crater_end > 0.0)
    above -= crater(here) * t * (2.0 - t) * (1.0 - share);
  return chord(point, half) + above;
}

double Bead::undercut(const PathPoint& point, double outside) const
{
  const double depth = point.q < 0.0 ? weld_.undercut_left : weld_.undercut_right;
  if (depth <= 0.0 || outside >= weld_.undercut_width)
    return 0.0;
  const double wave = std::sin(kPi * std::sqrt(outside / weld_.undercut_width));  // deepest near the toe
  return depth * rise(run(point.s)) * wave * wave;
}

/// The plates and what else lies on them beside the bead.
double Bead::ground(const PathPoint& point) const
{
  if (second_.width <= 0.0)
    return plateHeight(point);
  const double t = rise(run(point.s));
  const double half = 0.5 * second_.width * std::sqrt(t * (2.0 - t));
  const double q = point.q - second_.offset;
  if (second_.reinforcement <= 0.0 || !(std::abs(q) < half))
    return plateHeight(point);
  return plateHeight(point) + arc(q, half, second_.reinforcement * t * (2.0 - t));
}

double Bead::height(const PathPoint& point) const
{
  const double half = halfWidth(point.s);
  if (half <= 0.0)
    return ground(point);
  const double outside = std::abs(point.q) - half;
  if (outside < 0.0)
    return face(point, half);
  return ground(point) - undercut(point, outside);
}

double Bead::target(const PathPoint& point, double rest) const
{
  const double half = halfWidth(point.s);
  if (!(std::abs(point.q) < half))
    return plateHeight(point);
  // a parallel to the chord at this distance
  const double across = plateHeight(PathPoint{ half, point.s }) - plateHeight(PathPoint{ -half, point.s });
  return chord(point, half) + rest * std::hypot(2.0 * half, across) / (2.0 * half);
}

Zone Bead::zone(const PathPoint& point) const
{
  const double half = halfWidth(point.s);
  if (std::abs(point.q) < half || ground(point) > plateHeight(point))
    return Zone::Bead;
  const double slope = point.q < 0.0 ? slope_left_ : slope_right_;
  const double depth = half > 0.0 ? undercut(point, std::abs(point.q) - half) / std::hypot(1.0, slope) : 0.0;
  return depth > kUndercut ? Zone::Undercut : Zone::Plate;
}
}  // namespace simulation
}  // namespace weld_profiler
