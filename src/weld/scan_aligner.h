#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "motion_fit.h"
#include "moved_surface.h"
#include "parent_patches.h"
#include "toe_match.h"
#include "undercut_match.h"
#include "weld_profiler/weld/compare_params.h"
#include "weld_profiler/weld/scan_comparison.h"

namespace weld_profiler
{
namespace weld
{
/// What is known of the scan before.
struct AlignTarget
{
  const ScanGrid& grid;
  const Parents& parents;
  Eigen::Vector3d about;  ///< that motions are told about [m]
  Eigen::Vector3d along;  ///< of the weld's path in its middle, of length 1
};

/// What of the weld before may still stand in the scan after.
struct StandingMarks
{
  const ToeMatch& toes;
  const UndercutMatch& undercuts;
};

/// How points err, told from the parents of both scans.
struct PointNoise
{
  double factor = 1.0;  ///< the points' own sigmas are too small by this
  double alike = 1.0;   ///< this many neighbouring points count as one
};

/// Lays one scan on another by the parents, and by toes and undercuts where they were left standing.
class ScanAligner
{
public:
  /// The arguments must outlive the aligner.
  ScanAligner(const AlignTarget& before, const SurfaceView& after, const StandingMarks& marks,
              const CompareParams& params);

  /// @throws InputError when the scans do not overlap, the parents do not match or lie too far apart.
  ScanAlignment align();

  /// After align().
  PointNoise noise() const { return noise_; }

private:
  struct Laid
  {
    Eigen::Isometry3d motion;
    MotionStep last;
  };
  Laid lay(Eigen::Isometry3d motion);
  Laid layByUndercuts(const Laid& without);
  Eigen::Vector3d across() const { return before_.along.cross(up_).normalized(); }
  std::vector<MotionObservation> observe(const Eigen::Isometry3d& motion);
  void requireOverlap() const;
  void requireNear(const Vector6d& motion) const;
  void requireMatch(const MotionStep& step) const;
  Matrix6d knowledge() const;
  void tell(ScanAlignment& aligned) const;
  void measureNoise(const MotionStep& step);

  const AlignTarget& before_;
  const SurfaceView& after_;
  const StandingMarks& marks_;
  const CompareParams& params_;
  PlaceBins bins_;
  Eigen::Vector3d up_;  ///< normal of the plates
  std::vector<SurfaceSample> samples_;
  std::vector<std::size_t> used_;  ///< patch of each observation of a parent, in order
  bool by_toes_ = false;
  bool by_undercuts_ = false;
  PointNoise noise_;
};
}  // namespace weld
}  // namespace weld_profiler
