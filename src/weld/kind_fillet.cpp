#include <algorithm>
#include <cmath>

#include "kinds.h"
#include "statistics.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
/// A weld in the corner of two parents. Legs and throat from the root, where the parent lines meet.
class Fillet : public KindModel
{
public:
  WeldKind kind() const override { return WeldKind::Fillet; }

  double score(const SeamEvidence& evidence, const WeldParams& /*params*/) const override
  {
    if (!evidence.angle.measured())
      return 0.0;
    constexpr double kSmallest = 0.5, kSmall = 0.8, kLarge = 2.3, kLargest = 2.6;  // [rad]
    const double angle = evidence.angle.value;
    return std::min(1.0 - fade(angle, kSmallest, kSmall), fade(angle, kLarge, kLargest));
  }

  void measure(const SectionShape& shape, WeldSection& section) const override
  {
    section.misalignment = Quantity();  // of edges that lie side by side, not in a corner
    section.incomplete_fill = Quantity();
    if (!shape.whole())
      return;
    const Line& left = shape.left.line;
    const Line& right = shape.right.line;
    const double q = (left.height - right.height) / (right.slope - left.slope);
    const double z = left.at(q);
    // a parent that lies higher by its sigma moves the root along the other one
    const double turn_angle = right.angle() - left.angle();
    const double turn = std::abs(std::sin(turn_angle));
    const double along_left = shape.right.sigmaAt(q) * std::cos(right.angle()) / turn;
    const double along_right = shape.left.sigmaAt(q) * std::cos(left.angle()) / turn;
    section.leg_left = Quantity{ std::hypot(shape.toe_left.q - q, shape.toe_left.z - z),
                                 std::hypot(shape.toe_left.sigma, along_left) };
    section.leg_right = Quantity{ std::hypot(shape.toe_right.q - q, shape.toe_right.z - z),
                                  std::hypot(shape.toe_right.sigma, along_right) };
    section.throat =
        Quantity{ -shape.chord().above(q, z),
                  std::sqrt(square(shape.chordSigma(q)) + 0.5 * square(along_left) + 0.5 * square(along_right)) };
  }
};
}  // namespace

const KindModel& filletModel()
{
  static const Fillet model;
  return model;
}
}  // namespace weld
}  // namespace weld_profiler
