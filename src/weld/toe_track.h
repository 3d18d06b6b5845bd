#pragma once

#include <vector>

#include "path_frame.h"

namespace weld_profiler
{
namespace weld
{
/// Both toes of a cross-section: where they lie across the path, and how high.
struct ToePair
{
  double s = 0.0;
  double left = 0.0, right = 0.0;      ///< q [m]
  double z_left = 0.0, z_right = 0.0;  ///< [m]

  double width() const { return right - left; }

  /// Height of the chord of the toes at q.
  double chord(double q) const { return z_left + (q - left) / (right - left) * (z_right - z_left); }
};

/// The toes along a weld: those of the sections that have both, and straight lines between them. Immutable.
class ToeTrack
{
public:
  /// @param bridge  toes further apart than this are not connected [m].
  ToeTrack(const WeldResult& result, const PathFrame& frame, double bridge);

  const std::vector<ToePair>& pairs() const { return pairs_; }  ///< rising s

  bool has(double s) const;

  /// @pre has(s).
  ToePair at(double s) const;

private:
  std::vector<ToePair> pairs_;
  double bridge_ = 0.0;
};
}  // namespace weld
}  // namespace weld_profiler
