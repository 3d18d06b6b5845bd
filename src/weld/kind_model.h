#pragma once

#include <string>
#include <vector>

#include "section_shape.h"
#include "weld_profiler/weld/weld_result.h"

namespace weld_profiler
{
namespace weld
{
/// What all sections together say of how the parents lie.
struct SeamEvidence
{
  Quantity offset;  ///< right parent line above the left at the seam [m]
  Quantity angle;   ///< between the parent lines, > 0 = both rise outward [rad]
};

SeamEvidence seamEvidence(const std::vector<SectionShape>& shapes);

/// One kind of weld. Immutable, thread safe.
class KindModel
{
public:
  virtual ~KindModel() = default;
  virtual WeldKind kind() const = 0;

  /// How well the parents agree with this kind, 0..1. Without evidence (a parent missing) what can be said without.
  virtual double score(const SeamEvidence& evidence, const WeldParams& params) const = 0;

  /// Adds to a section what only this kind has, and takes away what it has not.
  virtual void measure(const SectionShape& shape, WeldSection& section) const = 0;
};

/// One a kind; a kind that is added here is known everywhere.
const std::vector<const KindModel*>& kindModels();

/// @throws PreconditionError for None.
const KindModel& kindModel(WeldKind kind);

/// Every kind's score, falling.
std::vector<KindScore> scoreKinds(const SeamEvidence& evidence, const WeldParams& params);

/// How far from one plate two parents are, in units of what still counts as one: < 1 = one plate.
double plateDistance(const SeamEvidence& evidence, const WeldParams& params);

/// 1 up to `full`, falling to 0 at `none`.
double fade(double value, double full, double none);
}  // namespace weld
}  // namespace weld_profiler
