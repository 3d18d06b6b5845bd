#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "motion_fit.h"
#include "path_frame.h"
#include "weld_profiler/weld/weld_result.h"

namespace weld_profiler
{
namespace weld
{
/// The toes of two scans of one weld. Where grinding left them standing they tell how the scans lie across the weld.
class ToeMatch
{
public:
  /// @param path  of the weld before; must outlive the match.
  ToeMatch(const WeldResult& before, const PathFrame& path, const WeldResult& after);

  /// Distances across the weld between the middles of the toes, section by section; empty when the toes are not those
  /// of before, as their distance tells.
  /// @param motion  lays the scan after on the one before.
  std::vector<MotionObservation> observe(const Eigen::Isometry3d& motion, const Eigen::Vector3d& about) const;

private:
  struct Station
  {
    double s = 0.0, left = 0.0, right = 0.0;  ///< of the scan before: q of the toes [m]
  };
  struct Pair
  {
    Eigen::Vector3d left, right;  ///< of the scan after [m]
    double sigma = 0.0;           ///< of their distance [m]
  };
  bool stationAt(double s, Station& station) const;

  const PathFrame& path_;
  std::vector<Station> stations_;  ///< rising s
  std::vector<Pair> pairs_;
};
}  // namespace weld
}  // namespace weld_profiler
