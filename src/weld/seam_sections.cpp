#include "seam_sections.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "along_weld.h"
#include "statistics.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kLever = 6e-3;                      // between the places that tell a parent line [m]
constexpr Continuation kPlate{ 8e-3, 8e-3, false };  // of a parent that is not in view
constexpr Continuation kToe{ 20e-3, 2e-3, true };    // of a toe, for maps
constexpr double kCourse = 3e-3;                     // half window of the toes' course [m]
constexpr double kShortPiece = 0.5;                  // of the median length: such a parent is rather continued
constexpr double kBridgedSigma = 2.0;                // a toe told from its neighbours is less certain than they

ParentFit& parentOf(SectionShape& shape, Side side)
{
  return side == Side::Left ? shape.left : shape.right;
}

ToeFit& toeOf(SectionShape& shape, Side side)
{
  return side == Side::Left ? shape.toe_left : shape.toe_right;
}

/// A face may fall from the toe of the higher plate, but not below the chord of the toes: that is no bead's.
void dropSunken(SectionShape& shape)
{
  if (!shape.whole())
    return;
  const double chord = shape.chord().angle();
  const auto sunken = [chord](const ToeFit& toe, double parent, double inward)
  { return toe.flank < 0.0 && toe.flank + inward * (parent - chord) < 0.0; };
  const bool left = sunken(shape.toe_left, shape.left.line.angle(), 1.0);
  const bool right = sunken(shape.toe_right, shape.right.line.angle(), -1.0);
  shape.toe_left.found = !left;
  shape.toe_right.found = !right;
}
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
}

void SeamSections::measureRoughly(const std::vector<double>& places)
{
  fit(places, {});
  for (const Side side : { Side::Left, Side::Right })
  {
    const AlongWeld course = courseAlong(places_, smoothToes(side), kCourse);
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
}

void SeamSections::fitParents(Side side)
{
  std::vector<double> rooms, lengths;
  for (std::size_t k = 0; k < size(); ++k)
    rooms.push_back(roomBeside(profiles_[k], side, guess_.toe(side, places_[k])));
  const double begin = parentBegin(median(rooms), params_);
  for (std::size_t k = 0; k < size(); ++k)
  {
    const double toe = guess_.toe(side, places_[k]);
    const Line guess = guess_.parent(side, profiles_[k].place, toe);
    ParentFit& fit = parentOf(shapes_[k], side);
    fit = fitParent(profiles_[k], ParentPiece{ side, toe, begin }, guess, params_);
    lengths.push_back(fit.valid() ? fit.correlated_cells : kNaN);
  }
  const double length = median(lengths);  // of one section alone it is hardly known
  for (std::size_t k = 0; k < size(); ++k)
  {
    ParentFit& fit = parentOf(shapes_[k], side);
    if (!fit.valid())
      continue;
    fit.covariance *= length / fit.correlated_cells;
    fit.correlated_cells = length;
  }
}

/// Sets aside fits to short pieces, as at the ends of an oblique weld: the plate continued from where more of it is in
/// view tells more.
void SeamSections::demoteShort(Side side)
{
  std::vector<double> lengths;
  for (SectionShape& shape : shapes_)
  {
    const ParentFit& fit = parentOf(shape, side);
    lengths.push_back(fit.valid() ? std::abs(fit.outer - fit.inner) : kNaN);
  }
  const double least = kShortPiece * median(lengths);
  short_parents_.assign(size(), ParentFit());
  for (std::size_t k = 0; k < size(); ++k)
  {
    if (lengths[k] < least)
      std::swap(short_parents_[k], parentOf(shapes_[k], side));
  }
}

/// Each parent line by its heights at two places, evened out along the weld and continued where it is not in view.
void SeamSections::smoothParents(Side side)
{
  std::vector<double> toes;
  for (const double s : places_)
    toes.push_back(guess_.toe(side, s));
  const double near = median(toes), far = near + sign(side) * kLever;
  AlongWeld near_heights, far_heights;
  ParentFit typical;
  for (SectionShape& shape : shapes_)
  {
    const ParentFit& fit = parentOf(shape, side);
    near_heights.value.push_back(fit.line.at(near));
    far_heights.value.push_back(fit.line.at(far));
    near_heights.sigma.push_back(fit.valid() ? fit.sigmaAt(near) : kNaN);
    far_heights.sigma.push_back(fit.valid() ? fit.sigmaAt(far) : kNaN);
    if (fit.valid())
      typical = fit;
  }
  if (!typical.valid())
    return;
  const AlongWeld at_near = continueAlong(places_, smoothAlong(places_, near_heights), kPlate);
  const AlongWeld at_far = continueAlong(places_, smoothAlong(places_, far_heights), kPlate);
  for (std::size_t k = 0; k < size(); ++k)
  {
    ParentFit& fit = parentOf(shapes_[k], side);
    if (!std::isfinite(at_near.value[k]) || !std::isfinite(at_far.value[k]))
    {
      fit = short_parents_[k];
      continue;
    }
    const bool seen = fit.valid();
    if (!seen)
      fit = typical;
    const double raw = fit.sigmaAt(near);
    fit.line.slope = (at_far.value[k] - at_near.value[k]) / (far - near);
    fit.line.height = at_near.value[k] - fit.line.slope * near;
    fit.covariance *= square(at_near.sigma[k] / raw);
  }
}

void SeamSections::fitToes()
{
  for (std::size_t k = 0; k < size(); ++k)
  {
    SectionShape& shape = shapes_[k];
    ToeQuestion question;
    question.guess = guess_.toe(Side::Left, places_[k]);
    question.opposite = guess_.toe(Side::Right, places_[k]);
    shape.toe_left = fitToe(profiles_[k], question, shape.left, params_);
    std::swap(question.guess, question.opposite);
    question.side = Side::Right;
    shape.toe_right = fitToe(profiles_[k], question, shape.right, params_);
    dropSunken(shape);
  }
}

AlongWeld SeamSections::smoothToes(Side side)
{
  AlongWeld raw;
  for (SectionShape& shape : shapes_)
  {
    const ToeFit& toe = toeOf(shape, side);
    raw.value.push_back(toe.found ? toe.q : kNaN);
    raw.sigma.push_back(toe.found ? toe.sigma : kNaN);
  }
  AlongWeld smooth = smoothAlong(places_, raw);
  for (std::size_t k = 0; k < size(); ++k)
  {
    ToeFit& toe = toeOf(shapes_[k], side);
    if (!toe.found)
      continue;
    toe.q = smooth.value[k];
    toe.z = parentOf(shapes_[k], side).line.at(toe.q);
    toe.sigma = std::hypot(smooth.sigma[k], toe.bias);
  }
  return smooth;
}

/// A toe under spatter, in a section that is otherwise seen, lies between its neighbours' toes.
void SeamSections::bridgeToes(Side side)
{
  std::size_t before = size();
  for (std::size_t k = 0; k < size(); ++k)
  {
    if (!toeOf(shapes_[k], side).found)
      continue;
    if (before < size() && k > before + 1 && places_[k] - places_[before] <= params_.max_bridge)
    {
      for (std::size_t j = before + 1; j < k; ++j)
        bridgeToe(side, before, j, k);
    }
    before = k;
  }
}

void SeamSections::bridgeToe(Side side, std::size_t before, std::size_t k, std::size_t after)
{
  SectionShape& shape = shapes_[k];
  const ParentFit& parent = parentOf(shape, side);
  const bool seen = profiles_[k].size() > std::min(profiles_[before].size(), profiles_[after].size()) / 2;
  if (!parent.valid() || !seen)
    return;
  const ToeFit& a = toeOf(shapes_[before], side);
  const ToeFit& b = toeOf(shapes_[after], side);
  const double share = (places_[k] - places_[before]) / (places_[after] - places_[before]);
  ToeFit& toe = toeOf(shape, side);
  toe = a;
  toe.bridged = true;
  toe.q = a.q + share * (b.q - a.q);
  toe.z = parent.line.at(toe.q);
  toe.sigma = kBridgedSigma * std::max(a.sigma, b.sigma);
}
}  // namespace weld
}  // namespace weld_profiler
