#pragma once

#include <cstdint>

#include "weld_profiler/core/scan.h"
#include "weld_profiler/simulation/scene_params.h"
#include "weld_profiler/simulation/simulated_scan.h"

namespace weld_profiler
{
namespace weld_accuracy
{
/// A simulated weld (randomWeldScene) before and after grinding, both scanned through the whole chain, and what is true
/// of them: the simulation's surfaces, integrated on a lattice of 0.05 mm over the scan before.
///
/// The scan after has other noise, no spatter and no ripples, goes on by 1.5 mm at both ends, and is in the frame of
/// the scan before: the part has not moved.
class GroundCase
{
public:
  /// @param rest  reinforcement that grinding leaves [m]; < 0: its share of what there was, with the sign changed.
  GroundCase(std::uint64_t seed, double rest);

  const SceneParams& scene() const { return before_scene_; }
  double width() const { return before_scene_.weld.width; }
  double length() const { return to_y_ - from_y_; }  ///< of the scan before, first row to last [m]
  double rest() const { return after_scene_.weld.reinforcement; }

  Scan before, after;
  double removed = 0.0;    ///< true volume [m^3]
  double remaining = 0.0;  ///< true volume of bead and spatter above the target [m^3]

  /// True surfaces over the frame of the scan before [m].
  double surfaceBefore(double x, double y) const;
  double surfaceAfter(double x, double y) const;
  double target(double x, double y) const;

private:
  void integrate();

  SceneParams before_scene_, after_scene_;
  SimulatedScan before_truth_, after_truth_;
  double from_y_ = 0.0, to_y_ = 0.0;
};
}  // namespace weld_accuracy
}  // namespace weld_profiler
