#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Geometry>

#include "motion_fit.h"
#include "moved_surface.h"
#include "parent_patches.h"
#include "path_frame.h"
#include "weld_zone.h"

namespace weld_profiler
{
namespace weld
{
/// The undercuts of the scan before. Where grinding left them standing their walls tell how the scans lie along the
/// plates.
class UndercutMatch
{
public:
  /// @param path  of the weld before; grid and path must outlive the match.
  UndercutMatch(const ScanGrid& grid, const GridMaps& maps, const PathFrame& path, const Parents& parents);

  bool empty() const { return patches_.empty(); }

  /// Sets the grid's points whose heights observe() and misfit() need.
  void want(std::vector<std::uint8_t>& mask) const;

  /// Distances between the walls, patch by patch.
  /// @param after  heights of the scan after over the grid's points.
  std::vector<MotionObservation> observe(const std::vector<SurfaceSample>& after, const Eigen::Vector3d& about) const;

  /// How badly the undercuts fit, as a share of what no undercut at all would: 0 = perfectly, 1 = not at all. Patches
  /// that were ground count as no fit.
  /// @param alike  share of a patch's depth; those farther apart do not fit.
  double misfit(const std::vector<SurfaceSample>& after, double alike) const;

  /// Whether enough of the undercuts are those of before.
  bool standing(const std::vector<SurfaceSample>& after) const;

  /// Where the undercuts fit best, along a line.
  /// @param motion  lays the scan after on the one before, but for a shift along `across`.
  /// @param reach   of the search to either side; no farther than 2 mm [m].
  Eigen::Isometry3d search(const SurfaceView& after, const Eigen::Isometry3d& motion, const Eigen::Vector3d& across,
                           double reach) const;

private:
  struct Patch
  {
    int side = 0;                                     ///< 0 = left of the path, 1 = right
    double s = 0.0;                                   ///< along the weld's path [m]
    Eigen::Vector2d along = Eigen::Vector2d::Zero();  ///< direction of the weld
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    Eigen::Vector2d slope = Eigen::Vector2d::Zero();  ///< dz/dx, dz/dy
    double depth = 0.0;                               ///< below the parent [m]
    std::vector<std::uint32_t> points;                ///< of the grid
  };
  void addPoint(std::size_t i, Patch& patch) const;
  bool finish(Patch& patch) const;
  void findDirections();
  void findSlope(const Eigen::Vector3d& parent, Patch& patch) const;
  double rise(const Patch& patch, const std::vector<SurfaceSample>& after) const;

  const ScanGrid& grid_;
  const GridMaps& maps_;
  const PathFrame& path_;
  std::vector<Patch> patches_;
};
}  // namespace weld
}  // namespace weld_profiler
