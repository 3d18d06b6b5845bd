#pragma once

#include "parent_fit.h"
#include "section_sampler.h"
#include "toe_fit.h"
#include "weld_profiler/weld/weld_params.h"
#include "weld_profiler/weld/weld_section.h"

namespace weld_profiler
{
namespace weld
{
/// The lines and points that a section's dimensions are told from.
struct SectionShape
{
  ParentFit left, right;
  ToeFit toe_left, toe_right;

  bool whole() const { return toe_left.found && toe_right.found; }

  const ParentFit& parent(Side side) const { return side == Side::Left ? left : right; }
  ParentFit& parent(Side side) { return side == Side::Left ? left : right; }
  const ToeFit& toe(Side side) const { return side == Side::Left ? toe_left : toe_right; }
  ToeFit& toe(Side side) { return side == Side::Left ? toe_left : toe_right; }

  /// Through both toes.
  Line chord() const;

  /// 1-sigma of the chord's height at q [m].
  double chordSigma(double q) const;

  /// Variance of a point times the number of neighbours that share its error [m^2].
  double energy() const;
};

/// A section's dimensions and what only the maps need of it.
struct SectionValues
{
  WeldSection section;
  double undercut_width_left = 0.0;  ///< 0 = no undercut beyond doubt [m]
  double undercut_width_right = 0.0;
};

/// The dimensions that every kind of weld has, after the definitions of docs/weld.md. What is missing stays NaN.
/// Place and stage of the section are the profile's and the caller's.
SectionValues sectionValues(const SectionProfile& profile, const SectionShape& shape, const WeldParams& params);
}  // namespace weld
}  // namespace weld_profiler
