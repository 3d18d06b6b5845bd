#include "weld_profiler/weld/grinding.h"

#include "grinding_lines.h"
#include "grinding_passes.h"
#include "weld_meshes.h"

namespace weld_profiler
{
GrindingPlan planGrinding(const Scan& scan, const WeldResult& result, const GrindingParams& params)
{
  params.validate();
  GrindingPlan plan;
  plan.frame_id = scan.frame_id;
  const weld::WeldShape shape(scan, result, params.surface);
  plan.reason = shape.reason();
  if (!plan.reason.empty())
    return plan;
  const weld::WeldLattice lattice = weld::makeLattice(shape, params.surface.mesh_step, params.surface.target_margin);
  WeldMeshes meshes = weld::makeMeshes(shape, lattice, params.surface);
  plan.bead = std::move(meshes.bead);
  plan.target = std::move(meshes.target);
  plan.reason = meshes.reason;
  if (lattice.rows.empty())
    return plan;
  weld::addLines(shape, lattice, params.point_spacing, plan);
  if (plan.reason.empty())
    weld::addPasses(shape, lattice, params, plan);
  return plan;
}
}  // namespace weld_profiler
