#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "weld_profiler/weld/triangle_mesh.h"

namespace weld_profiler
{
/// Writes a mesh as PLY, binary little endian: `property float x y z nx ny nz`, `property list uchar int
/// vertex_indices`, metres. PCL, VTK and through them noether refuse faces of `uchar uint` and vertices of double.
/// @param comments  one line each, for the file's header (weld id, frame, calibration).
/// @throws PreconditionError when there is not one normal a vertex, a triangle names a vertex that does not exist, or a
///         comment is longer than a line.
void writePly(const TriangleMesh& mesh, std::ostream& out, const std::vector<std::string>& comments = {});
}  // namespace weld_profiler
