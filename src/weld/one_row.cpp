#include <algorithm>
#include <cmath>

#include "kind_model.h"
#include "lone_parents.h"
#include "measuring.h"
#include "row_beads.h"
#include "row_yaw.h"
#include "seam_summary.h"
#include "statistics.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
const RowBead* strongest(const RowFindings& findings)
{
  const RowBead* best = nullptr;
  for (const RowBead& bead : findings.beads)
  {
    if (best == nullptr || (bead.whole() && !best->whole()) ||
        (bead.whole() == best->whole() && bead.area > best->area))
      best = &bead;
  }
  return best;
}

SectionProfile foreshortened(const ScanGrid& grid, const RowBead& bead, double yaw)
{
  SectionProfile profile;
  profile.place.x = 0.5 * (bead.x_left + bead.x_right);
  profile.place.y = grid.row_y.front();
  profile.place.yaw = yaw;
  for (int column = 0; column < grid.cells; ++column)
  {
    const std::size_t i = grid.at(0, column);
    if (!std::isfinite(grid.z[i]))
      continue;
    profile.q.push_back((static_cast<double>(grid.x[i]) - profile.place.x) * std::cos(yaw));
    profile.z.push_back(static_cast<double>(grid.z[i]));
  }
  return profile;
}

/// A line over x as one over q.
Line foreshortened(const Line& line, double x, double yaw)
{
  return Line{ line.at(x), line.slope / std::cos(yaw) };
}

/// The kind that was asked for, or the likeliest; None where none is likely.
WeldKind kindOf(const SectionShape& shape, const WeldParams& params)
{
  const KindScore best = scoreKinds(seamEvidence({ shape }), params).front();
  for (const KindModel* model : kindModels())
  {
    if (params.kind == name(model->kind()))
      return model->kind();
  }
  return best.score > 0.0 ? best.kind : WeldKind::None;
}
/// Without a face that rises from both lines they may be no parents: a part of the face, where a plate is hardly in
/// view. Nor is an offset told that is not known better than a width must be.
void refuseDoubtfulParents(const WeldParams& params, WeldSection& section)
{
  if (section.hasBead() && !(section.misalignment.sigma > params.max_width_sigma))
    return;
  section.misalignment = Quantity();
  section.angle = Quantity();
}
}  // namespace

WeldSection measureOneRow(const ScanGrid& grid, const Quantity& told_yaw, const WeldParams& params)
{
  const double yaw = told_yaw.value;
  WeldSection section;
  section.yaw = yaw, section.yaw_sigma = told_yaw.sigma;
  section.reference = SectionReference::ParentLines;
  if (grid.rows == 0)
    return section;
  const RowFindings findings = findRowBeads(grid, 0, params);
  const RowBead* bead = strongest(findings);
  if (bead == nullptr)
    return section;
  const SectionProfile profile = foreshortened(grid, *bead, yaw);
  const double half = 0.5 * (bead->x_right - bead->x_left) * std::cos(yaw);
  SectionShape shape;
  const auto parent = [&](Side side, double toe, const Line& line)
  {
    const Line guess = foreshortened(line, profile.place.x, yaw);
    ParentPiece piece{ side, toe, 0.0 };
    const double room = guess.valid() ? roomBeside(profile, piece, guess, params) : 0.0;
    piece.begin = parentBegin(room, params);
    piece.length = room - piece.begin;
    return fitParent(profile, piece, guess, params);
  };
  shape.left = parent(Side::Left, -half, bead->left);
  shape.right = parent(Side::Right, half, bead->right);
  widenParents(profile, shape);
  shape.toe_left = fitToe(profile, ToeQuestion{ Side::Left, -half, half }, shape.left, params);
  shape.toe_right = fitToe(profile, ToeQuestion{ Side::Right, half, -half }, shape.right, params);
  for (ToeFit* toe : { &shape.toe_left, &shape.toe_right })
    toe->sigma = std::hypot(toe->sigma, toe->bias);
  section = sectionValues(profile, shape, params).section;
  const WeldKind kind = kindOf(shape, params);
  if (kind != WeldKind::None)
    kindModel(kind).measure(shape, section);
  refuseDoubtful(params, section);
  refuseDoubtfulParents(params, section);
  section.yaw_sigma = told_yaw.sigma;
  addYawUncertainty(shape, section);
  return section;
}
}  // namespace weld
}  // namespace weld_profiler
