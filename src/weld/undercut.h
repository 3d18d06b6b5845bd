#pragma once

#include "section_shape.h"

namespace weld_profiler
{
namespace weld
{
/// A groove beside a toe.
struct Undercut
{
  Quantity depth;      ///< below the extended parent line, >= 0; not measured where the surface was not seen [m]
  double width = 0.0;  ///< from the toe outward, 0 = none beyond doubt [m]
};

Undercut measureUndercut(const SectionProfile& profile, const SectionShape& shape, Side side, const WeldParams& params);
}  // namespace weld
}  // namespace weld_profiler
