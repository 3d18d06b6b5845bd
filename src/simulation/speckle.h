#pragma once

#include <vector>

#include "weld_profiler/simulation/scene_params.h"

namespace weld_profiler
{
namespace simulation
{
/// Speckle as a factor of mean 1 that is fixed to the surface: smoothed white noise through an exponential
/// (log-normal).
class Speckle
{
public:
  /// @param x_metres_px,y_metres_px  surface per pixel on the flat plate, so that a grain is round in the image.
  Speckle(const SceneParams& scene, double x_metres_px, double y_metres_px);

  bool on() const { return !tile_.empty(); }

  /// @param x,y  fixed frame [m].
  float operator()(double x, double y) const;

private:
  std::vector<float> tile_;
  double x_scale_ = 0.0, y_scale_ = 0.0;  ///< tile points a metre
};
}  // namespace simulation
}  // namespace weld_profiler
