#include "seam_sections.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "along_weld.h"
#include "row_bends.h"
#include "statistics.h"
#include "toe_course.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kLever = 6e-3;                      // between the places that tell a parent line [m]
constexpr Continuation kPlate{ 8e-3, 8e-3, false };  // of a parent that is not in view
constexpr Continuation kToe{ 20e-3, 2e-3, true };    // of a toe, for maps
constexpr double kCourse = 6e-3;                     // of toes before or behind another that tell where it is [m]
constexpr std::size_t kCorrelationStep = 4;          // sections from one that tells it to the next
constexpr double kOddToe = 5e-4;                     // a toe lies this far inside of where the others are [m]
constexpr double kRoomMargin = 2e-4;                 // a parent is looked at so far beyond where it was last seen [m]
constexpr double kShortPiece = 0.5;                  // of the median length: such a parent is rather continued
}  // namespace

void SeamSections::fit(const std::vector<double>& places, const std::vector<std::uint8_t>& masked)
{
  places_ = places;
  profiles_.resize(places.size());
  shapes_.assign(places.size(), SectionShape());
  for (std::size_t k = 0; k < places.size(); ++k)
    sampler_.sample(places[k], masked, profiles_[k]);
  for (const Side side : { Side::Left, Side::Right })
  {
    fitParents(side);
    demoteShort(side);
    smoothParents(side);
  }
  fitToes();
  for (const Side side : { Side::Left, Side::Right })
    dropLone(side);
}

void SeamSections::measureRoughly(const std::vector<double>& places)
{
  fit(places, {});
  for (const Side side : { Side::Left, Side::Right })
  {
    const AlongWeld course = toeCourse(places_, smoothToes(side), side, kCourse);
    (side == Side::Left ? mapped_left_ : mapped_right_) = continueAlong(places_, course, kToe).value;
  }
}

void SeamSections::measure(const std::vector<double>& places, const std::vector<std::uint8_t>& masked)
{
  fit(places, masked);
  for (const Side side : { Side::Left, Side::Right })
  {
    const AlongWeld smooth = smoothToes(side);
    (side == Side::Left ? mapped_left_ : mapped_right_) = continueAlong(places_, smooth, kToe).value;
    bridgeToes(side);
  }
  std::vector<double> crests;
  for (const SectionShape& shape : shapes_)
    crests.push_back(shape.whole() ? 0.5 * (shape.toe_left.q + shape.toe_right.q) : kNaN);
  const std::vector<double> bends = rowBends(sampler_, masked, places_, crests);
  for (std::size_t k = 0; k < size(); ++k)
    profiles_[k].row_bend = bends[k];
}

void SeamSections::fitParents(Side side)
{
  std::vector<double> rooms, lengths;
  for (std::size_t k = 0; k < size(); ++k)
  {
    const ParentPiece all{ side, guess_.toe(side, places_[k]), 0.0 };
    const Line guess = guess_.parent(side, profiles_[k].place, all.toe);
    rooms.push_back(guess.valid() ? roomBeside(profiles_[k], all, guess, params_) : kNaN);
  }
  const double room = median(rooms);
  const double begin = parentBegin(room, params_);
  for (std::size_t k = 0; k < size(); ++k)
  {
    const double toe = guess_.toe(side, places_[k]);
    const Line guess = guess_.parent(side, profiles_[k].place, toe);
    ParentFit& fit = shapes_[k].parent(side);
    // where another bead or a clamp stands near, the parent ends before it
    const double seen =
        std::isfinite(rooms[k]) ? std::max(rooms[k], room) + kRoomMargin - begin : params_.parent_length;
    const bool told = lengths.empty() || k % kCorrelationStep == 0;
    fit = fitParent(profiles_[k], ParentPiece{ side, toe, begin, seen, told }, guess, params_);
    if (told && fit.valid())
      lengths.push_back(fit.correlated_cells);
  }
  const double cells = median(lengths);  // of one section alone it is hardly known
  for (std::size_t k = 0; k < size(); ++k)
  {
    ParentFit& fit = shapes_[k].parent(side);
    if (!fit.valid())
      continue;
    fit.covariance *= cells / fit.correlated_cells;
    fit.correlated_cells = cells;
  }
}

/// Sets aside fits to short pieces, as at the ends of an oblique weld: the plate continued from where more of it is in
/// view tells more.
void SeamSections::demoteShort(Side side)
{
  std::vector<double> lengths;
  for (SectionShape& shape : shapes_)
  {
    const ParentFit& fit = shape.parent(side);
    lengths.push_back(fit.valid() ? std::abs(fit.outer - fit.inner) : kNaN);
  }
  const double least = kShortPiece * median(lengths);
  short_parents_.assign(size(), ParentFit());
  for (std::size_t k = 0; k < size(); ++k)
  {
    if (lengths[k] < least)
      std::swap(short_parents_[k], shapes_[k].parent(side));
  }
}

/// Whether a section's toe is looked for well inside of where the other sections have theirs.
bool SeamSections::isInside(Side side, const Lever& lever, std::size_t k) const
{
  return sign(side) * (lever.near - guess_.toe(side, places_[k])) > kOddToe;
}

/// Sets aside what was taken for a parent where the real one leaves the view: it departs from the plate, and its toe
/// lies inside the bead that the other sections show.
void SeamSections::demoteOdd(Side side, const Lever& lever, const ParentPlate& plate)
{
  // farther off the biweight counts it for nothing
  const double most = std::max(params_.flatness, kTukeyReach * plate.scatter());
  for (std::size_t k = 0; k < size(); ++k)
  {
    ParentFit& fit = shapes_[k].parent(side);
    const Line line = plate.lineAt(profiles_[k].place);
    const double off = std::max(std::abs(fit.line.at(lever.near) - line.at(lever.near)),
                                std::abs(fit.line.at(lever.far) - line.at(lever.far)));
    if (fit.valid() && off > most && isInside(side, lever, k))
      std::swap(short_parents_[k], fit);
  }
}

/// Each parent line by its heights over the plate at two places, evened out along the weld and continued where it is
/// not in view.
void SeamSections::smoothParents(Side side)
{
  std::vector<double> toes;
  for (const double s : places_)
    toes.push_back(guess_.toe(side, s));
  const double toe = median(toes);
  const Lever lever{ toe, toe + sign(side) * kLever };
  std::vector<ParentPlate::Piece> pieces;
  for (std::size_t k = 0; k < size(); ++k)
  {
    if (shapes_[k].parent(side).valid() && !isInside(side, lever, k))
      pieces.push_back(ParentPlate::Piece{ profiles_[k].place, shapes_[k].parent(side).line });
  }
  const ParentPlate plate(pieces, lever.near, lever.far);
  if (pieces.size() > 1)
    demoteOdd(side, lever, plate);
  AlongWeld near_heights, far_heights;
  ParentFit typical;
  for (std::size_t k = 0; k < size(); ++k)
  {
    const ParentFit& fit = shapes_[k].parent(side);
    const Line base = plate.lineAt(profiles_[k].place);
    near_heights.value.push_back(fit.line.at(lever.near) - base.at(lever.near));
    far_heights.value.push_back(fit.line.at(lever.far) - base.at(lever.far));
    near_heights.sigma.push_back(fit.valid() ? fit.sigmaAt(lever.near) : kNaN);
    far_heights.sigma.push_back(fit.valid() ? fit.sigmaAt(lever.far) : kNaN);
    if (fit.valid())
      typical = fit;
  }
  if (!typical.valid())
    return;
  const AlongWeld at_near = continueAlong(places_, smoothAlong(places_, near_heights), kPlate);
  const AlongWeld at_far = continueAlong(places_, smoothAlong(places_, far_heights), kPlate);
  for (std::size_t k = 0; k < size(); ++k)
  {
    ParentFit& fit = shapes_[k].parent(side);
    if (!std::isfinite(at_near.value[k]) || !std::isfinite(at_far.value[k]))
    {
      fit = short_parents_[k];
      continue;
    }
    const bool seen = fit.valid();
    if (!seen)
      fit = typical;
    const double raw = fit.sigmaAt(lever.near);
    const Line base = plate.lineAt(profiles_[k].place);
    const double slope = (at_far.value[k] - at_near.value[k]) / (lever.far - lever.near);
    fit.line = Line{ base.height + at_near.value[k] - slope * lever.near, base.slope + slope };
    fit.covariance *= square(at_near.sigma[k] / raw);
  }
}

}  // namespace weld
}  // namespace weld_profiler
