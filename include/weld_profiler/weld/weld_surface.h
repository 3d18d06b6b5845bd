#pragma once

#include <string>

#include "weld_profiler/core/scan.h"
#include "weld_profiler/weld/triangle_mesh.h"
#include "weld_profiler/weld/weld_result.h"

namespace weld_profiler
{
/// How the surfaces of a weld are made into meshes. SI.
struct WeldSurfaceParams
{
  double mesh_step = 2e-4;       ///< of the mesh, along and across the weld [m], 0.00005..0.005
  double target_margin = 3e-3;   ///< of the parents that the target surface shows beside each toe [m], 0..0.05;
                                 ///< less than 1.5 mesh_step = none
  double max_gap = 5e-4;         ///< wider gaps between points are holes; the surface is told from points within
                                 ///< 0.6 of it [m], 0.0001..0.01
  double edge_inset = 0.0;       ///< the bead's mesh ends this far inside the toes [m], 0..0.005
  double min_angle_deg = 10.0;   ///< triangles with a sharper corner are left out [deg], 0..25
  double min_piece_area = 1e-6;  ///< loose pieces of less area are left out [m^2], 0..0.01

  /// @throws ConfigError naming field, value and range.
  void validate() const;

  template <class Visitor>
  void visit(Visitor&& v)
  {
    v("mesh_step", mesh_step);
    v("target_margin", target_margin);
    v("max_gap", max_gap);
    v("edge_inset", edge_inset);
    v("min_angle_deg", min_angle_deg);
    v("min_piece_area", min_piece_area);
  }
};

/// The surfaces of a weld, in the cloud's frame. Both face the sensor (+z). Empty where there is nothing to show.
struct WeldMeshes
{
  TriangleMesh bead;    ///< the bead as it is, spatter on it included, toe to toe
  TriangleMesh target;  ///< what grinding is to leave: over the bead and a margin of the parents
  std::string reason;   ///< why there is none; empty = nothing to say
};

/// Meshes of a measured weld on a grid along and across its path, each vertex told from the points around it (local
/// plane), so that triangles are near to right-angled whatever the scan's pitch. Holes stay where data is missing.
/// Edges belong to one or two triangles, vertices to one fan.
/// @param result  of the same scan.
/// @throws ConfigError as WeldSurfaceParams::validate, PreconditionError when result and scan do not belong together.
WeldMeshes makeWeldMeshes(const Scan& scan, const WeldResult& result,
                          const WeldSurfaceParams& params = WeldSurfaceParams());
}  // namespace weld_profiler
