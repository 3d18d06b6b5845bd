#pragma once

#include <vector>

#include "section_shape.h"

namespace weld_profiler
{
namespace weld
{
/// The sections along a weld, and what of them is to be told anew.
struct ToesAlong
{
  Side side = Side::Left;
  const std::vector<double>& places;            ///< of the sections, rising [m]
  const std::vector<SectionProfile>& profiles;  ///< of each
  const std::vector<ToeQuestion>& questions;    ///< of each: where its toe was looked for
  bool begins = false, ends = false;            ///< the bead does, within the scan
};

/// Where a flat face is rippled, the place at which one section's face meets its parent goes in and out with the
/// ripples, inward more than outward, and where it runs out no toe is found at all: their mean is short. Such toes are
/// told from faces that are evened out along the weld over more than a ripple, so that it cancels out before it is
/// divided by the face's slope. Toes that do not scatter are left as they are.
/// @param shapes  with the toes found in each section by itself; evened out ones are marked so.
void evenToes(const ToesAlong& along, const WeldParams& params, std::vector<SectionShape>& shapes);
}  // namespace weld
}  // namespace weld_profiler
