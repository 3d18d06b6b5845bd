#include <cmath>

#include "kinds.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
/// Two plates edge to edge: they meet at a small angle, and are not one plate, as an offset or an angle shows, or
/// who asks for a butt weld: two plates without either look like one.
class Butt : public KindModel
{
public:
  WeldKind kind() const override { return WeldKind::Butt; }

  double score(const SeamEvidence& evidence, const WeldParams& params) const override
  {
    if (!evidence.angle.measured())
      return 0.5;  // one parent is not in view
    const double in_line = fade(std::abs(evidence.angle.value), 0.5, 0.8);
    if (params.kind == name(kind()))
      return in_line;
    const double distance = plateDistance(evidence, params);
    return in_line * (1.0 - std::exp(-0.7 * distance * distance));
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
