#pragma once

#include "weld_lattice.h"
#include "weld_profiler/weld/grinding.h"

namespace weld_profiler
{
namespace weld
{
/// Fills passes, layers and volumes of a plan; says in its reason why there are no passes.
void addPasses(const WeldShape& shape, const WeldLattice& lattice, const GrindingParams& params, GrindingPlan& plan);
}  // namespace weld
}  // namespace weld_profiler
