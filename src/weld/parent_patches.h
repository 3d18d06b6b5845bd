#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "moved_surface.h"
#include "path_frame.h"
#include "scan_grid.h"

namespace weld_profiler
{
namespace weld
{
/// A small piece of a parent, in the scan before.
struct ParentPatch
{
  int side = 0;  ///< 0 = left of the path, 1 = right
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  std::vector<std::uint32_t> points;  ///< of the grid
};

/// What of a scan is parent.
struct ParentChoice
{
  const std::vector<std::uint8_t>& labels;  ///< of the grid's points
  const std::vector<float>& distance;       ///< from the weld [m]
  double beyond = 0.0;                      ///< points nearer to the weld are none [m]
  double half_width = 0.0;                  ///< nor those nearer to the path, where the bead has ended [m]
};

/// The parents beside a weld, cut into patches, and the plane that most of each side's patches lie in.
struct Parents
{
  std::vector<ParentPatch> patches;
  std::array<Eigen::Vector3d, 2> normals{ { Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitZ() } };  ///< upward
  std::array<int, 2> count{ { 0, 0 } };                                                              ///< patches a side
};

Parents findParents(const ScanGrid& grid, const PathFrame& path, const ParentChoice& choice);

/// Mean distance along z of a surface above the patch's points; NaN when less than half of them are known.
double meanRise(const ScanGrid& grid, const ParentPatch& patch, const std::vector<SurfaceSample>& surface);
}  // namespace weld
}  // namespace weld_profiler
