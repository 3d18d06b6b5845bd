#include "weld_profiler/geometry/triangulator.h"

#include <cmath>
#include <string>

#include "weld_profiler/core/errors.h"
#include "weld_profiler/geometry/calibration_file.h"

namespace weld_profiler
{
namespace
{
constexpr double kFarthest = 1e3;  // [m], of a point; beyond it the ray is as good as parallel to the plane

Calibration validated(Calibration calibration)
{
  validateCalibration(calibration, "calibration");
  return calibration;
}

void requireSound(const Stripe& stripe, std::uint32_t cells)
{
  const std::size_t count = stripe.size();
  for (const auto* field : { &stripe.u, &stripe.v, &stripe.normal_angle, &stripe.intensity, &stripe.sigma })
    if (field->size() != count)
      throw PreconditionError("stripe has arrays of " + std::to_string(count) + " and " +
                              std::to_string(field->size()) + " entries, all must have the same length");
  if (stripe.flags.size() != count)
    throw PreconditionError("stripe has " + std::to_string(count) + " cells and " +
                            std::to_string(stripe.flags.size()) + " flags, all arrays must have the same length");
  for (std::size_t i = 0; i < count; ++i)
    if (stripe.cell[i] >= cells || (i > 0 && stripe.cell[i] <= stripe.cell[i - 1]))
      throw PreconditionError("stripe cell " + std::to_string(stripe.cell[i]) + " at place " + std::to_string(i) +
                              ", cells must rise strictly and lie below " + std::to_string(cells));
}
}  // namespace

Triangulator::Triangulator(const Calibration& calibration)
  : calibration_(validated(calibration)),
    camera_(calibration_.camera),
    normal_(Eigen::Map<const Eigen::Vector3d>(calibration_.laser_plane.normal.data())),
    distance_(calibration_.laser_plane.distance)
{
}

void Triangulator::triangulate(const Stripe& stripe, SensorProfile& profile) const
{
  profile.direction = stripe.direction;
  profile.cells =
      static_cast<std::uint32_t>(stripe.direction == Direction::AlongU ? camera_.width() : camera_.height());
  requireSound(stripe, profile.cells);
  profile.points.clear();
  profile.points.reserve(stripe.size());
  SensorPoint point;
  for (std::size_t i = 0; i < stripe.size(); ++i)
    if (triangulatePoint(stripe[i], point))
      profile.points.push_back(point);
}

bool Triangulator::triangulatePoint(const StripePoint& centre, SensorPoint& point) const
{
  const CameraModel::Ray ray = camera_.rayWithSlope(centre.u, centre.v);
  const Eigen::Vector3d direction(ray.direction.x(), ray.direction.y(), 1.0);
  const double depth = distance_ / normal_.dot(direction);
  if (!(depth > 0.0 && depth <= kFarthest))
    return false;
  point.position = depth * direction;

  // p = t r with t = d / (n.r); when r moves by dr, dt = -t (n.dr) / (n.r), hence dp = t dr - p (n.dr) / (n.r).
  const double angle = centre.normal_angle;
  const Eigen::Vector2d turn = ray.slope * (centre.sigma * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  const Eigen::Vector3d move(turn.x(), turn.y(), 0.0);
  point.spread = (depth * move - point.position * (normal_.dot(move) * depth / distance_)).cast<float>();
  if (!point.position.allFinite() || !point.spread.allFinite() || !std::isfinite(centre.intensity))
    return false;
  point.intensity = centre.intensity;
  point.cell = centre.cell;
  point.flags = centre.flags;
  return true;
}
}  // namespace weld_profiler
