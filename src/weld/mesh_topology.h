#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "weld_profiler/weld/triangle_mesh.h"

namespace weld_profiler
{
namespace weld
{
using Triangle = std::array<std::uint32_t, 3>;

/// Leaves out the triangles of pieces with less than this area. Pieces are connected by edges; a common vertex does not
/// connect.
void dropSmallPieces(const std::vector<Eigen::Vector3d>& nodes, double min_area, std::vector<Triangle>& triangles);

/// A mesh of the nodes that triangles use. Where fans of triangles touch in one vertex only, each gets its own:
/// half-edge structures (pcl::geometry, CGAL) take no other. Normals are those of the triangles around, by area, evened
/// out with the neighbours'.
/// @pre  an edge belongs to at most two triangles.
TriangleMesh connect(const std::vector<Eigen::Vector3d>& nodes, const std::vector<Triangle>& triangles);
}  // namespace weld
}  // namespace weld_profiler
