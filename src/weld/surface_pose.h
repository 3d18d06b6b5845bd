#pragma once

#include "local_surface.h"
#include "path_frame.h"
#include "weld_profiler/weld/grinding.h"

namespace weld_profiler
{
namespace weld
{
/// A pose on a surface: z along its normal, x along the path as far as the surface allows.
/// @param z      where the pose lies, not needed to be the surface's height.
/// @param slope  the surface there.
SurfacePose poseAt(const PathFrame& frame, const PathPlace& place, double z, const HeightSample& slope);

/// The same place, travelled the other way: turned by half a turn about the normal.
SurfacePose reversed(const SurfacePose& pose);

/// Moved along its normal.
SurfacePose lifted(const SurfacePose& pose, double height);
}  // namespace weld
}  // namespace weld_profiler
