#pragma once

#include "weld_lattice.h"
#include "weld_profiler/weld/triangle_mesh.h"

namespace weld_profiler
{
namespace weld
{
/// A mesh of heights over a lattice, facing +z: two triangles where four neighbouring nodes are known, one where three
/// are. Triangles with a corner sharper than params.min_angle_deg, and loose pieces smaller than params.min_piece_area,
/// are left out. Every edge belongs to one or two triangles, every vertex to one fan of them.
/// @param z  of the lattice's nodes, NaN = not known.
TriangleMesh meshOf(const WeldLattice& lattice, const std::vector<double>& z, const WeldSurfaceParams& params);
}  // namespace weld
}  // namespace weld_profiler
