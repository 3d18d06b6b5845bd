#pragma once

#include "lattice_mesh.h"
#include "weld_lattice.h"

namespace weld_profiler
{
namespace weld
{
/// @param lattice  of the shape, with the target's margin.
WeldMeshes makeMeshes(const WeldShape& shape, const WeldLattice& lattice, const WeldSurfaceParams& params);
}  // namespace weld
}  // namespace weld_profiler
