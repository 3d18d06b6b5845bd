#include <cmath>

#include "kinds.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
/// A bead on one plate: both parents lie in one plane, within what parents may leave it and what is known of them.
class BeadOnPlate : public KindModel
{
public:
  WeldKind kind() const override { return WeldKind::BeadOnPlate; }

  double score(const SeamEvidence& evidence, const WeldParams& params) const override
  {
    if (!evidence.angle.measured())
      return 0.4;  // as likely as a butt weld, which is judged more strictly
    const double distance = plateDistance(evidence, params);
    return std::exp(-0.7 * distance * distance);
  }

  void measure(const SectionShape& /*shape*/, WeldSection& /*section*/) const override {}
};
}  // namespace

const KindModel& beadOnPlateModel()
{
  static const BeadOnPlate model;
  return model;
}
}  // namespace weld
}  // namespace weld_profiler
