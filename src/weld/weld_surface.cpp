#include "weld_profiler/weld/weld_surface.h"

#include <sstream>

#include "weld_meshes.h"
#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
void WeldSurfaceParams::validate() const
{
  requireRange("mesh_step", mesh_step, 5e-5, 5e-3, "m");
  requireRange("target_margin", target_margin, 0.0, 0.05, "m");
  requireRange("max_gap", max_gap, 1e-4, 0.01, "m");
  requireRange("edge_inset", edge_inset, 0.0, 5e-3, "m");
  requireRange("min_angle_deg", min_angle_deg, 0.0, 25.0, "deg");
  requireRange("min_piece_area", min_piece_area, 0.0, 0.01, "m^2");
}

WeldMeshes makeWeldMeshes(const Scan& scan, const WeldResult& result, const WeldSurfaceParams& params)
{
  params.validate();
  const weld::WeldShape shape(scan, result, params);
  if (!shape.reason().empty())
  {
    WeldMeshes none;
    none.reason = shape.reason();
    return none;
  }
  return weld::makeMeshes(shape, weld::makeLattice(shape, params.mesh_step, params.target_margin), params);
}

namespace weld
{
namespace
{
std::string shortest(double value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}
}  // namespace

WeldMeshes makeMeshes(const WeldShape& shape, const WeldLattice& lattice, const WeldSurfaceParams& params)
{
  WeldMeshes meshes;
  if (lattice.rows.empty())
  {
    meshes.reason = "the weld is too small for a mesh of this step";
    return meshes;
  }
  meshes.target = meshOf(lattice, lattice.target, params);
  if (params.edge_inset > 0.0)
  {
    const WeldLattice inner = makeLattice(shape, params.mesh_step, -params.edge_inset);
    meshes.bead = meshOf(inner, inner.bead, params);
  }
  else
    meshes.bead = meshOf(lattice, lattice.bead, params);
  if (meshes.bead.empty() && params.edge_inset > 0.0 && !meshOf(lattice, lattice.bead, params).empty())
    meshes.reason = "edge_inset " + shortest(1e3 * params.edge_inset) +
                    " mm leaves nothing of the bead, must be less than half its width";
  else if (meshes.bead.empty())
    meshes.reason = "no piece of the bead is seen well enough for a mesh";
  return meshes;
}
}  // namespace weld
}  // namespace weld_profiler
