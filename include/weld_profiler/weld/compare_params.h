#pragma once

namespace weld_profiler
{
/// How two scans of one weld are compared. SI.
struct CompareParams
{
  double over_ground_limit = 5e-5;  ///< deeper below the target than this is over-ground [m], 0.000001..0.01
  double min_spot_area = 1e-7;      ///< smaller places are none [m^2], 0..0.0001
  double placement = 5e-4;          ///< 1-sigma of how exactly the part lay in its old place along the plates; counts
                                    ///< where no surface tells [m], 0.000001..0.01
  double placement_turn_deg = 0.5;  ///< and of its turn in their plane [deg], 0.001..10
  double max_residual = 3e-5;       ///< parents that lie further apart (RMS) are not the same [m], 0.000001..0.001
  double max_shift = 0.01;    ///< scans further from each other along any axis are not of one place [m], 0.001..0.1
  double max_turn_deg = 5.0;  ///< nor those turned by more [deg], 0.1..20

  /// @throws ConfigError naming field, value and range.
  void validate() const;

  template <class Visitor>
  void visit(Visitor&& v)
  {
    v("over_ground_limit", over_ground_limit);
    v("min_spot_area", min_spot_area);
    v("placement", placement);
    v("placement_turn_deg", placement_turn_deg);
    v("max_residual", max_residual);
    v("max_shift", max_shift);
    v("max_turn_deg", max_turn_deg);
  }
};
}  // namespace weld_profiler
