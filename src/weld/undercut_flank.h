#pragma once

#include <vector>

#include <Eigen/Core>

#include "weld_profiler/weld/quantity.h"

namespace weld_profiler
{
namespace weld
{
/// Where the inner flank of an undercut comes up to the parent line: the toe as seen from outside. For faces so flat
/// that they meet the line nowhere in particular; the flank's own bend leaves 0.04 mm of doubt.
/// @param points   (u, height above the parent line) with u rising inward [m].
/// @param toe      u of the toe as far as it is known.
/// @param scatter  of a point [m].
/// @return u of the toe; not measured where there is no undercut beside it.
Quantity flankToe(const std::vector<Eigen::Vector2d>& points, double toe, double scatter);
}  // namespace weld
}  // namespace weld_profiler
