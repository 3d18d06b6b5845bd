#pragma once

#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "weld_profiler/core/scan.h"
#include "weld_profiler/weld/grinding_params.h"
#include "weld_profiler/weld/triangle_mesh.h"
#include "weld_profiler/weld/weld_result.h"

namespace weld_profiler
{
/// A place on a surface in the cloud's frame: z = the surface's normal, toward the sensor; x = travel of the tool,
/// along the weld toward +y, whichever way the stage ran (back in every other lane of order alternate).
struct SurfacePose
{
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
};

/// Poses along the weld without a gap between them.
using PoseLine = std::vector<SurfacePose>;

/// One place of a pass.
struct GrindingPoint
{
  SurfacePose pose;  ///< on what this pass leaves
  double removal =
      0.0;              ///< largest depth to remove here along the pose's z, of the strip that is this pass's share [m]
  double volume = 0.0;  ///< to remove here; over all passes this adds up to the whole [m^3]
};

/// One travel of the tool along the weld, in contact all the way.
struct GrindingPass
{
  int layer = 0;  ///< from 0 = the uppermost
  int lane = 0;   ///< across the weld, from 0 = left
  std::vector<GrindingPoint> points;
  SurfacePose approach;  ///< above the first point
  SurfacePose retract;   ///< above the last
};

/// What a grinding robot is told of one weld.
struct GrindingPlan
{
  std::string frame_id;  ///< of everything in here
  std::string reason;    ///< why there are no passes, or what they leave out; empty = nothing to say
  std::vector<PoseLine> toe_left, toe_right;  ///< z = normal of the target
  std::vector<PoseLine> crest;                ///< middle of the bead's highest fifth; z = normal of the bead
  std::vector<GrindingPass> passes;           ///< in the order of grinding
  int layers = 0;
  double removal_volume = 0.0;  ///< of the bead above the target, where both are known [m^3]
  double planned_volume = 0.0;  ///< of it, what the passes remove [m^3]
  TriangleMesh bead, target;    ///< as makeWeldMeshes
};

/// Plans how to grind a measured weld down to its target surface: layers from the top down, in each of them lanes side
/// by side that follow the toes, passes where there is something to remove, none across a hole in the data. Depths are
/// along the target's normal. Of a fillet the target is the chord of the toes, and lanes stay between these: beyond
/// them the parents rise.
///
/// Says nothing of the robot: no reach, no collision beyond that, no tool offset.
/// @param result  of the same scan. Without a weld the plan is empty and says why.
/// @throws ConfigError as GrindingParams::validate, PreconditionError when result and scan do not belong together.
GrindingPlan planGrinding(const Scan& scan, const WeldResult& result, const GrindingParams& params = GrindingParams());
}  // namespace weld_profiler
