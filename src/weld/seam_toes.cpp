#include <algorithm>
#include <cmath>
#include <utility>

#include "evened_toes.h"
#include "seam_sections.h"
#include "statistics.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kNear = 1e-3;          // sections this near should agree on a toe ... [m]
constexpr double kAgree = 4.0;          // ... within so many sigmas
constexpr double kAgreeLeast = 1.5e-4;  // ... and this [m]
constexpr double kAgreeShare = 0.34;    // of them at least
constexpr int kEndRows = 6;             // of the scan: a low bead is not recognised in each of its rows
constexpr double kBridgedSigma = 2.0;   // a toe told from its neighbours is less certain than they

Side otherSide(Side side)
{
  return side == Side::Left ? Side::Right : Side::Left;
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

/// A toe that few of the sections around found, or found there, is none.
void SeamSections::dropLone(Side side)
{
  std::vector<std::size_t> lone;
  for (std::size_t k = 0; k < size(); ++k)
  {
    const ToeFit& toe = shapes_[k].toe(side);
    if (!toe.found)
      continue;
    std::size_t around = 0, agreeing = 0;
    auto j = static_cast<std::size_t>(std::lower_bound(places_.begin(), places_.end(), places_[k] - kNear) -
                                      places_.begin());
    for (; j < size() && places_[j] <= places_[k] + kNear; ++j)
    {
      const ToeFit& other = shapes_[j].toe(side);
      around += shapes_[j].parent(side).valid() ? 1 : 0;
      const double reach = kAgree * std::hypot(toe.sigma, other.sigma) + kAgreeLeast;
      agreeing += other.found && std::abs(other.q - toe.q) < reach ? 1 : 0;
    }
    if (static_cast<double>(agreeing) < kAgreeShare * static_cast<double>(around))
      lone.push_back(k);
  }
  for (const std::size_t k : lone)
    shapes_[k].toe(side).found = false;
}

AlongWeld SeamSections::smoothToes(Side side)
{
  std::vector<ToeQuestion> questions;
  questions.reserve(size());
  for (const double s : places_)
    questions.push_back(ToeQuestion{ side, guess_.toe(side, s), guess_.toe(otherSide(side), s) });
  const bool begins = size() > 0 && sampler_.rowsToEnd(profiles_.front().row) > kEndRows;
  const bool ends = size() > 0 && sampler_.rowsToEnd(profiles_.back().row) > kEndRows;
  evenToes(ToesAlong{ side, places_, profiles_, questions, begins, ends }, params_, shapes_);
  AlongWeld raw;
  for (SectionShape& shape : shapes_)
  {
    const ToeFit& toe = shape.toe(side);
    const bool told = toe.found && !toe.evened;
    raw.value.push_back(told ? toe.q : kNaN);
    raw.sigma.push_back(told ? toe.sigma : kNaN);
  }
  AlongWeld smooth = smoothAlong(places_, raw);
  for (std::size_t k = 0; k < size(); ++k)
  {
    ToeFit& toe = shapes_[k].toe(side);
    if (!toe.found)
      continue;
    if (toe.evened)
      smooth.value[k] = toe.q, smooth.sigma[k] = toe.sigma;
    toe.q = smooth.value[k];
    toe.z = shapes_[k].parent(side).line.at(toe.q);
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
    if (!shapes_[k].toe(side).found)
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
  const ParentFit& parent = shape.parent(side);
  const bool seen = profiles_[k].size() > std::min(profiles_[before].size(), profiles_[after].size()) / 2;
  if (!parent.valid() || !seen)
    return;
  const ToeFit& a = shapes_[before].toe(side);
  const ToeFit& b = shapes_[after].toe(side);
  const double share = (places_[k] - places_[before]) / (places_[after] - places_[before]);
  ToeFit& toe = shape.toe(side);
  toe = a;
  toe.bridged = true;
  toe.q = a.q + share * (b.q - a.q);
  toe.z = parent.line.at(toe.q);
  toe.sigma = kBridgedSigma * std::max(a.sigma, b.sigma);
}
}  // namespace weld
}  // namespace weld_profiler
