#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "weld_profiler/core/scan.h"
#include "weld_profiler/weld/compare_params.h"
#include "weld_profiler/weld/quantity.h"
#include "weld_profiler/weld/weld_params.h"
#include "weld_profiler/weld/weld_section.h"

namespace weld_profiler
{
/// How the scan after was laid on the scan before: p_before = about + shift + rotation (p_after - about).
struct ScanAlignment
{
  Eigen::Vector3d about = Eigen::Vector3d::Zero();     ///< the middle of the weld in the scan before [m]
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();     ///< [m]
  Eigen::Vector3d rotation = Eigen::Vector3d::Zero();  ///< rotation vector [rad]
  Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();  ///< of shift and rotation
  double residual = 0.0;      ///< RMS distance of the parents' patches after it, without those that were ground [m]
  bool across_told = false;   ///< surfaces tell the shift across the weld; else it is taken as the scans lie
  bool along_told = false;    ///< and the shift along it
  bool turn_told = false;     ///< and the turn in the plates' plane
  bool by_toes = false;       ///< the toes that were left standing took part
  bool by_undercuts = false;  ///< and the undercuts
  Eigen::Isometry3d before_T_after = Eigen::Isometry3d::Identity();
};

/// A place where the grinder went deeper than the target.
struct OverGroundSpot
{
  double x = 0.0, y = 0.0;  ///< its deepest place, in the frame of the scan before [m]
  double s = 0.0;           ///< along the weld's path [m]
  Quantity depth;           ///< below the target there, > 0 [m]
  double area = 0.0;        ///< deeper than the limit, seen from above [m^2]
};

/// What grinding took off and what it left. Maps are organised as the scan before: a row a row of it, a column a cell.
struct ScanComparison
{
  WeldKind kind = WeldKind::None;  ///< of the weld before
  ScanAlignment aligned;
  Quantity
      removed_volume;  ///< before less after, over the weld and `undercut_reach` around it, where both saw it [m^3]
  Quantity remaining_volume;                ///< of the bead and spatter above the target, where both saw it [m^3]
  std::vector<OverGroundSpot> over_ground;  ///< deepest first
  double measured_share = 0.0;     ///< of the area of the weld and around it that the scan before shows, seen in both
  std::vector<std::string> notes;  ///< what a reader must know
  std::uint32_t rows = 0, cells = 0;
  std::vector<float> after;      ///< z after, NaN = not measured [m]
  std::vector<float> removed;    ///< z before less z after [m]
  std::vector<float> remaining;  ///< z after less the target [m]
  std::vector<float> spot;       ///< 0 = not over-ground, else the place's number from 1; NaN as remaining
};

/// Compares scans of a weld before and after grinding, after the definitions of docs/compare.md. Immutable, thread
/// safe.
///
/// The scan after is laid on the one before by the parents beside the weld; it may be turned and shifted by a little,
/// have other rows and columns, and show no bead any more. Poor for: parents ground all over; a part that was turned
/// round.
class ScanComparer
{
public:
  /// @param measuring  how the scan before is measured: it tells the target, the path and the parents.
  /// @throws ConfigError as the parameters' validate().
  explicit ScanComparer(const WeldParams& measuring = WeldParams(), const CompareParams& params = CompareParams());

  /// @throws InputError when the scan before shows no weld, the scans do not overlap or the parents do not match;
  ///         PreconditionError when a cell lies outside its scan.
  ScanComparison compare(const Scan& before, const Scan& after) const;

  const WeldParams& measuring() const { return measuring_; }
  const CompareParams& params() const { return params_; }

private:
  WeldParams measuring_;
  CompareParams params_;
};
}  // namespace weld_profiler
