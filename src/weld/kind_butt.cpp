#include <cmath>

#include "kinds.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
/// Two plates edge to edge: they meet at a small angle, and are not one plate, as an offset or an angle shows.
class Butt : public KindModel
{
public:
  WeldKind kind() const override { return WeldKind::Butt; }

  double score(const SeamEvidence& evidence, const WeldParams& params) const override
  {
    if (!evidence.angle.measured())
      return 0.5;  // one parent is not in view
    const double distance = plateDistance(evidence, params);
    return fade(std::abs(evidence.angle.value), 0.5, 0.8) * (1.0 - std::exp(-0.7 * distance * distance));
  }

  void measure(const SectionShape& /*shape*/, WeldSection& /*section*/) const override {}
};
}  // namespace

const KindModel& buttModel()
{
  static const Butt model;
  return model;
}
}  // namespace weld
}  // namespace weld_profiler
