#include "seam_maps.h"

#include <algorithm>
#include <cmath>

#include "statistics.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
class MapFiller
{
public:
  MapFiller(const SeamView& view, const std::vector<double>& undercut_left, const std::vector<double>& undercut_right,
            const WeldParams& params)
    : view_(view), undercut_left_(undercut_left), undercut_right_(undercut_right), params_(params)
  {
    for (std::size_t k = 0; k < view.sections.size(); ++k)
      limits_.push_back(limitsOf(k));
  }

  void operator()(WeldResult& result) const
  {
    for (std::size_t row = 0; row < view_.scan.rows.size(); ++row)
      for (const CloudPoint& point : view_.scan.rows[row].points)
        fill(row, point, result);
  }

private:
  /// What a section's points are held against: the same for all of them.
  struct Limits
  {
    double rest = 0.0;                               ///< of the target above the chord [m]
    double left = 0.0, right = 0.0;                  ///< distance from a parent that is still its surface [m]
    double upright_left = 1.0, upright_right = 1.0;  ///< distance from a parent for a height above it
  };

  Limits limitsOf(std::size_t k) const
  {
    const SectionShape& shape = view_.sections.shape(k);
    const double least = 3.0 * params_.flatness;
    return Limits{ restAbove(view_.zones.chord(k), params_), std::max(least, 8.0 * shape.left.scatter),
                   std::max(least, 8.0 * shape.right.scatter), 1.0 / std::sqrt(1.0 + square(shape.left.line.slope)),
                   1.0 / std::sqrt(1.0 + square(shape.right.line.slope)) };
  }

  void fill(std::size_t row, const CloudPoint& point, WeldResult& result) const
  {
    if (!std::isfinite(point.x) || !std::isfinite(point.y) || !std::isfinite(point.z) || view_.grid.row_of[row] < 0)
      return;
    const std::size_t in_grid = view_.grid.at(view_.grid.row_of[row], view_.grid.column(point.cell));
    const bool measured = std::isfinite(view_.grid.z[in_grid]);
    const PathPlace place = measured ? view_.sampler.place(in_grid)
                                     : view_.path.locate(static_cast<double>(point.x), static_cast<double>(point.y),
                                                         view_.sampler.place(in_grid).s);
    const Stray stray = measured ? view_.strays.kind[in_grid] : Stray::None;
    const std::size_t k = view_.zones.nearestSection(place.s);
    const double z = static_cast<double>(point.z);
    const std::size_t at = row * view_.scan.cells + point.cell;
    const Zone zone = view_.zones.zone(k, place.q);
    const WeldLabel label = labelOf(Spot{ k, place, z, zone, stray });
    result.labels[at] = static_cast<std::uint8_t>(label);
    const double flush = view_.zones.flush(k, place.q, zone);
    if (!std::isfinite(flush) || beyondEnds(place.s))
      return;
    const double target = flush + (zone == Zone::Weld ? limits_[k].rest : 0.0);
    result.target[at] = static_cast<float>(target);
    if (label == WeldLabel::Bead || label == WeldLabel::Spatter)
      result.removal[at] = static_cast<float>(std::max(0.0, z - target));
    else if (label == WeldLabel::Base || label == WeldLabel::Undercut)
      result.removal[at] = 0.0F;
  }

  bool beyondEnds(double s) const
  {
    const std::vector<double>& places = view_.sections.places();
    return (view_.begins && s < places.front()) || (view_.ends && s > places.back());
  }

  /// What is known of a point of the scan.
  struct Spot
  {
    std::size_t k;  ///< the section nearest to it
    PathPlace place;
    double z;
    Zone zone;
    Stray stray;
  };

  WeldLabel labelOf(const Spot& spot) const
  {
    const std::size_t k = spot.k;
    const PathPlace& place = spot.place;
    if (spot.stray == Stray::Foreign)
      return WeldLabel::Unknown;
    if (spot.stray == Stray::Spatter)
      return WeldLabel::Spatter;
    if (spot.zone == Zone::Nowhere)
      return WeldLabel::Unknown;
    if (beyondEnds(place.s))
      return besideEnd(k, place, spot.z) ? WeldLabel::Base : WeldLabel::Unknown;
    if (spot.zone == Zone::Weld)
      return WeldLabel::Bead;
    const bool left = spot.zone == Zone::LeftParent;
    const double outside = std::abs(place.q - (left ? view_.zones.leftToe(k) : view_.zones.rightToe(k)));
    if (outside < (left ? undercut_left_[k] : undercut_right_[k]))
      return WeldLabel::Undercut;
    // rims of undercuts too shallow to be one lie near the toe
    const bool plate = outside < params_.undercut_reach ||
                       std::abs(offParent(k, left, place.q, spot.z)) <
                           (left ? limits_[k].left : limits_[k].right) + view_.zones.slack(place.s);
    return plate ? WeldLabel::Base : WeldLabel::Unknown;
  }

  double offParent(std::size_t k, bool left, double q, double z) const
  {
    const SectionShape& shape = view_.sections.shape(k);
    return left ? (z - shape.left.line.at(q)) * limits_[k].upright_left
                : (z - shape.right.line.at(q)) * limits_[k].upright_right;
  }

  /// Plate before the bead begins and behind where it ends: near one of the parents continued.
  bool besideEnd(std::size_t k, const PathPlace& place, double z) const
  {
    const double tolerance = std::max(limits_[k].left, limits_[k].right) + view_.zones.slack(place.s);
    return std::abs(offParent(k, true, place.q, z)) < tolerance ||
           std::abs(offParent(k, false, place.q, z)) < tolerance;
  }

  const SeamView& view_;
  const std::vector<double>& undercut_left_;
  const std::vector<double>& undercut_right_;
  const WeldParams& params_;
  std::vector<Limits> limits_;  ///< one a section
};
}  // namespace

double restAbove(const Line& chord, const WeldParams& params)
{
  return params.target == "rest" ? params.rest_height * std::sqrt(1.0 + square(chord.slope)) : 0.0;
}

void fillMaps(const SeamView& view, const std::vector<double>& undercut_left, const std::vector<double>& undercut_right,
              const WeldParams& params, WeldResult& result)
{
  MapFiller(view, undercut_left, undercut_right, params)(result);
  result.runs_out = !view.begins || !view.ends;
}
}  // namespace weld
}  // namespace weld_profiler
