#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "weld_profiler/weld/weld_result.h"

namespace weld_profiler
{
namespace weld
{
/// Where a point lies relative to the weld's path, seen from above: q to the right of it, s along it.
struct PathPlace
{
  double q = 0.0, s = 0.0;
};

/// A place that the path goes through, as far as is known.
struct PathSample
{
  double x = 0.0, y = 0.0;
  double sigma = 0.0;  ///< of x [m]
};

/// The weld's path: a smooth curve x(y), s = 0 at from_y. Immutable, thread safe.
///
/// Each of its places comes from a parabola fitted to the samples around it, robustly (Tukey's biweight), with a yaw
/// and a curvature as far from zero as welds have them for a prior: three rows 0.1 mm apart do not make a yaw.
class WeldPath
{
public:
  /// @param samples  at least one; any order.
  /// @param from_y,to_y  where the bead begins and ends.
  /// @param reach    the path is continued this far beyond [m].
  WeldPath(const std::vector<PathSample>& samples, double from_y, double to_y, double reach);

  /// The path's place at s; beyond its ends straight on.
  WeldPathPoint at(double s) const;

  /// Where the path reaches a y: its s.
  double sAt(double y) const;

  /// Exact to the second order between the curve's points, which are 0.25 mm apart.
  /// @param near_s  a guess; the nearer the faster.
  PathPlace locate(double x, double y, double near_s) const;

  /// Neighbouring points of a row, as many as are located in step.
  static constexpr std::size_t kTogether = 8;
  struct Together
  {
    std::array<double, kTogether> x, y;  ///< where they are [m]
    std::array<double, kTogether> q, s;  ///< their places, filled [m]
  };
  void locate(double near_s, Together& points) const;

  double length() const { return length_; }  ///< from the bead's first end to its last

  /// 1-sigma of the yaw where the path reaches a y; grows where it is continued [rad].
  double yawSigma(double y) const;

private:
  /// A point with what locate() needs of the curve there.
  struct Frame
  {
    double x, y, s;
    double cosine, sine;  ///< of the yaw
    double turn;          ///< d yaw / d s [1/m]
  };
  void spaceEvenly(double from_y);
  void fillFrames();
  std::size_t indexOf(double s) const;

  std::vector<WeldPathPoint> points_;  ///< rising y, equal steps in s
  std::vector<Frame> frames_;          ///< one a point
  double from_s_ = 0.0;
  double length_ = 0.0;
  std::vector<double> yaw_sigmas_;  ///< equal steps in y, from first_y_ on
  double first_y_ = 0.0;
};
}  // namespace weld
}  // namespace weld_profiler
