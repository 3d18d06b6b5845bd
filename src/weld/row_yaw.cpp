#include "row_yaw.h"

#include <algorithm>
#include <cmath>

#include "statistics.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kMost = 0.7;  // of the cosine of a yaw that nothing is known of
constexpr double kPi = 3.14159265358979323846;

/// Relative uncertainty of the cosine of a normally distributed yaw, from its first two derivatives.
double cosineSigma(double yaw, double sigma)
{
  return std::min(kMost, std::sqrt(square(std::tan(yaw) * sigma) + 0.75 * square(sigma * sigma)));
}

void grow(double change, Quantity& quantity)
{
  if (quantity.measured() && std::isfinite(change))
    quantity.sigma = std::hypot(quantity.sigma, change);
}

/// How values change where all that lies across the weld shrinks about q = 0 and heights stay.
struct Shrinking
{
  double scale = 1.0;

  double slope(double slope) const { return slope / scale; }

  double angle(const Line& line) const { return std::atan(slope(line.slope)) - line.angle(); }

  /// Of a distance from a line.
  void fromLine(const Line& line, Quantity& distance) const
  {
    grow(distance.value * (std::cos(line.angle() + angle(line)) / std::cos(line.angle()) - 1.0), distance);
  }

  /// Of the distance of two points that lie so far apart across the weld and in height.
  void between(double across, double up, Quantity& distance) const
  {
    grow(std::hypot(scale * across, up) - std::hypot(across, up), distance);
  }

  /// Of pi less the angle between a parent and the face.
  void toe(const Line& parent, Side side, Quantity& toe) const
  {
    const double outward = sign(side);
    const double face = kPi - toe.value + std::atan(-outward * parent.slope);  // seen inward
    const double turned =
        std::abs(std::cos(face)) > 1e-3 ? std::atan(slope(std::tan(face))) - std::atan(std::tan(face)) : 0.0;
    grow(turned + outward * angle(parent), toe);
  }

  /// Of offset and angle of the parents.
  void parents(const SectionShape& shape, WeldSection& section) const
  {
    const double change = angle(shape.right.line) - angle(shape.left.line);
    const double tilt = 0.5 * (shape.right.line.angle() + shape.left.line.angle());
    const double tilted = 0.5 * (angle(shape.right.line) + angle(shape.left.line));
    const double turn = shape.right.line.angle() - shape.left.line.angle();
    const double before = std::cos(turn) * std::cos(tilt);
    grow(section.misalignment.value * (std::cos(turn + change) * std::cos(tilt + tilted) / before - 1.0),
         section.misalignment);
    grow(change, section.angle);
  }
};

void growToe(double q, const WeldSection& section, double sigma, SectionPoint& toe)
{
  const double twice = 2.0 * section.yaw;
  grow(q * std::hypot(std::sin(twice) * sigma, std::cos(twice) * square(sigma)), toe.x);
  grow(q * std::hypot(std::cos(twice) * sigma, std::sin(twice) * square(sigma)), toe.y);
}
}  // namespace

void addYawUncertainty(const SectionShape& shape, WeldSection& section)
{
  const double sigma = section.yaw_sigma;
  const Shrinking shrinking{ 1.0 - cosineSigma(section.yaw, sigma) };
  shrinking.parents(shape, section);
  shrinking.fromLine(shape.left.line, section.undercut_left);
  shrinking.fromLine(shape.right.line, section.undercut_right);
  growToe(shape.toe_left.q, section, sigma, section.toe_left);
  growToe(shape.toe_right.q, section, sigma, section.toe_right);
  if (!shape.whole())
    return;
  const Line chord = shape.chord();
  shrinking.between(shape.toe_right.q - shape.toe_left.q, shape.toe_right.z - shape.toe_left.z, section.width);
  shrinking.fromLine(chord, section.reinforcement);
  shrinking.fromLine(chord, section.incomplete_fill);
  shrinking.fromLine(shape.left.line, section.height_left);
  shrinking.fromLine(shape.right.line, section.height_right);
  shrinking.toe(shape.left.line, Side::Left, section.toe_angle_left);
  shrinking.toe(shape.right.line, Side::Right, section.toe_angle_right);
  grow(section.area.value * (1.0 - shrinking.scale), section.area);
  const double q =
      (shape.left.line.height - shape.right.line.height) / (shape.right.line.slope - shape.left.line.slope);
  const double z = shape.left.line.at(q);
  shrinking.between(shape.toe_left.q - q, shape.toe_left.z - z, section.leg_left);
  shrinking.between(shape.toe_right.q - q, shape.toe_right.z - z, section.leg_right);
  shrinking.fromLine(chord, section.throat);
}
}  // namespace weld
}  // namespace weld_profiler
