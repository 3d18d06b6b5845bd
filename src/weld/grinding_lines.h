#pragma once

#include "weld_lattice.h"
#include "weld_profiler/weld/grinding.h"

namespace weld_profiler
{
namespace weld
{
/// Fills toe_left, toe_right and crest of a plan.
void addLines(const WeldShape& shape, const WeldLattice& lattice, double point_spacing, GrindingPlan& plan);

/// Places from the first toes of a weld to its last, so many equal steps that none is much longer than asked for.
std::vector<double> placesAlong(const WeldShape& shape, double spacing);
}  // namespace weld
}  // namespace weld_profiler
