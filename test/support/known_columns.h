#pragma once

#include <cmath>

#include "stripe/column_track.h"
#include "support/render_stripe.h"

namespace weld_profiler
{
namespace test_support
{
constexpr float kNoise = 0.3F;  // grey levels: an 8-bit image's rounding

/// 16 bit: its rounding moves no centre by 1e-4 px.
inline StripePicture sceneOf(double degrees, double row, double sigma)
{
  StripePicture scene = straight(degrees, row);
  scene.width = 203;
  scene.height = 160;
  scene.sigma = sigma;
  scene.bit_depth = 16;
  return scene;
}

/// The stripe's half width down a column.
inline double columnSigma(const StripePicture& scene, double u)
{
  const double slope = scene.slope(u);
  return scene.sigma * std::sqrt(1.0 + slope * slope);
}

/// A track of one piece over all columns, so far off the true line.
inline ColumnTrack trackOf(const StripePicture& scene, double off = 0.0)
{
  ColumnTrack track;
  track.resize(static_cast<std::size_t>(scene.width) + 2 * ColumnTrack::kGuard);
  track.pieces.push_back(ColumnTrack::Piece{ ColumnTrack::kGuard, 0, scene.width });
  const double level = scene.bit_depth == 8 ? 1.0 : 257.0;
  for (int u = 0; u < scene.width; ++u)
  {
    const auto slot = static_cast<std::size_t>(u) + ColumnTrack::kGuard;
    track.v[slot] = static_cast<float>(scene.row(u) + off);
    track.sigma[slot] = static_cast<float>(columnSigma(scene, u));
    track.background[slot] = static_cast<float>(level * scene.background);
  }
  return track;
}

inline std::size_t slotOf(int u)
{
  return static_cast<std::size_t>(u) + ColumnTrack::kGuard;
}
}  // namespace test_support
}  // namespace weld_profiler
