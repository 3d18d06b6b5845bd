#include "kind_model.h"

#include <algorithm>
#include <cmath>

#include "kinds.h"
#include "statistics.h"
#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kRadPerDeg = 0.017453292519943295;

/// Median along the weld; sections err alike where their parents were evened out, so its sigma is that of one.
Quantity typical(const std::vector<double>& values, const std::vector<double>& sigmas)
{
  return Quantity{ median(values), median(sigmas) };
}
}  // namespace

SeamEvidence seamEvidence(const std::vector<SectionShape>& shapes)
{
  std::vector<double> offsets, offset_sigmas, angles, angle_sigmas;
  for (const SectionShape& shape : shapes)
  {
    if (!shape.whole())
      continue;
    const double seam = 0.5 * (shape.toe_left.q + shape.toe_right.q);
    offsets.push_back(shape.right.line.at(seam) - shape.left.line.at(seam));
    offset_sigmas.push_back(std::hypot(shape.left.sigmaAt(seam), shape.right.sigmaAt(seam)));
    angles.push_back(shape.right.line.angle() - shape.left.line.angle());
    angle_sigmas.push_back(std::sqrt(shape.left.covariance(1, 1) + shape.right.covariance(1, 1)));
  }
  return SeamEvidence{ typical(offsets, offset_sigmas), typical(angles, angle_sigmas) };
}

const std::vector<const KindModel*>& kindModels()
{
  static const std::vector<const KindModel*> models = { &buttModel(), &filletModel(), &beadOnPlateModel() };
  return models;
}

const KindModel& kindModel(WeldKind kind)
{
  for (const KindModel* model : kindModels())
  {
    if (model->kind() == kind)
      return *model;
  }
  throw PreconditionError(std::string("there is no weld kind '") + name(kind) + "' to measure");
}

std::vector<KindScore> scoreKinds(const SeamEvidence& evidence, const WeldParams& params)
{
  std::vector<KindScore> scores;
  for (const KindModel* model : kindModels())
    scores.push_back(KindScore{ model->kind(), model->score(evidence, params) });
  std::stable_sort(scores.begin(), scores.end(),
                   [](const KindScore& a, const KindScore& b) { return a.score > b.score; });
  return scores;
}

double plateDistance(const SeamEvidence& evidence, const WeldParams& params)
{
  const double offset = std::hypot(params.same_plate_offset, 2.0 * evidence.offset.sigma);
  const double angle = std::hypot(params.same_plate_angle_deg * kRadPerDeg, 2.0 * evidence.angle.sigma);
  return std::max(std::abs(evidence.offset.value) / offset, std::abs(evidence.angle.value) / angle);
}

double fade(double value, double full, double none)
{
  return std::min(1.0, std::max(0.0, (none - value) / (none - full)));
}
}  // namespace weld
}  // namespace weld_profiler
