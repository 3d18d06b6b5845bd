#pragma once

#include <cstdint>
#include <vector>

#include "weld_profiler/simulation/scene_params.h"

namespace weld_profiler
{
namespace simulation
{
/// Light that is not the laser's: room, arc, flashes of the arc, sparks. Immutable, thread safe.
class Light
{
public:
  Light(const SceneParams& scene, int width, int height);

  /// Mean signal of each pixel, width x height [DN]; empty in the dark.
  std::vector<float> field(int frame) const;

  /// Is the frame hit by a flash?
  bool flashes(int frame) const;

private:
  struct Spot
  {
    double level, u, v, radius;  ///< falls to a half at the radius
  };

  void addRoom(std::vector<float>& field) const;
  void addSpot(const Spot& spot, std::vector<float>& field) const;
  void addSparks(int frame, std::vector<float>& field) const;
  double transmission(double of_filter) const { return light_.filter ? of_filter : 1.0; }

  SceneLight light_;
  std::uint64_t seed_;
  int width_, height_;
};
}  // namespace simulation
}  // namespace weld_profiler
