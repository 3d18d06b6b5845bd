#pragma once

#include <vector>

#include <Eigen/Core>

#include "face_arc.h"
#include "weld_profiler/weld/weld_params.h"

namespace weld_profiler
{
namespace weld
{
/// How far from its toe a face is fitted [m].
/// @param width  of the weld, roughly [m].
double faceReach(double width, const WeldParams& params);

/// The face's points from beyond the kink's blur inward, those near the toe weighing most; none where the face is not
/// seen near it.
/// @param points  of the outline, the first coordinate rising inward.
std::vector<FacePoint> faceWindow(const std::vector<Eigen::Vector2d>& points, const Eigen::Vector2d& toe, double reach,
                                  const WeldParams& params);
}  // namespace weld
}  // namespace weld_profiler
