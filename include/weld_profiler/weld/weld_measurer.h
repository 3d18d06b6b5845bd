#pragma once

#include "weld_profiler/core/scan.h"
#include "weld_profiler/weld/weld_params.h"
#include "weld_profiler/weld/weld_result.h"

namespace weld_profiler
{
/// Finds the weld in an organised scan and measures it, after the definitions of docs/weld.md. Immutable, thread safe.
///
/// Good for: one bead on metal that is straight across the weld on either side, seen from above, running within about
/// 40 deg of the scan axis. Poor for: parents bent within a few millimetres, faces steeper than 75 deg.
class WeldMeasurer
{
public:
  /// @throws ConfigError as WeldParams::validate.
  explicit WeldMeasurer(const WeldParams& params = WeldParams());

  /// A scan without a weld gives kind None and a reason, never an exception. Points that were filled in across a gap
  /// (stripe_flag::kInterpolated) are not measured; they are labelled.
  /// @throws PreconditionError when a cell lies outside the scan.
  WeldResult measure(const Scan& scan) const;

  /// One provisional section from one profile: what a row shows, times the cosine of the yaw (of a running scan:
  /// LiveWeld). Nothing is known of the
  /// neighbours, so it is less certain than a section of measure() and may miss a bead or take another for it.
  /// Misalignment and angle are NaN where a parent is hardly in view.
  /// @param yaw  of the weld's path against y, where the row is; its sigma is in what is told [rad].
  /// @return a section without a width where the profile shows no bead.
  /// @throws PreconditionError when a cell lies outside the profile, or a yaw is no number.
  WeldSection measureRow(const Profile& profile, const Quantity& yaw = { 0.0, 0.0 }) const;

  const WeldParams& params() const { return params_; }

private:
  WeldParams params_;
};
}  // namespace weld_profiler
