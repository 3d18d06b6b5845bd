#pragma once

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "weld_profiler/weld/weld_result.h"

namespace weld_profiler
{
/// A hollow in a face, a paraboloid.
struct Pit
{
  double x = 0.0, y = 0.006, diameter = 0.001, depth = 3e-4;  ///< [m]

  double operator()(double px, double py) const
  {
    const double r = std::hypot(px - x, py - y) / (0.5 * diameter);
    return depth * std::max(0.0, 1.0 - r * r);
  }
};

/// The pit is the one spot of a result, a pore of its size.
inline void expectOnePore(const WeldResult& result, const Pit& pit, double depth_tolerance)
{
  ASSERT_EQ(result.spots.size(), 1u);
  const WeldSpot& spot = result.spots.front();
  EXPECT_EQ(spot.kind, WeldSpot::Kind::Pore);
  EXPECT_NEAR(spot.diameter.value, pit.diameter, 2.0 * spot.diameter.sigma);
  EXPECT_LT(spot.diameter.sigma, 0.15 * pit.diameter);
  EXPECT_NEAR(spot.height.value, -pit.depth, depth_tolerance);
}

/// Every height that is told is the crest's; of at least so many sections.
inline void expectHeights(const WeldResult& result, double crest, std::size_t at_least)
{
  std::size_t told = 0;
  for (const WeldSection& section : result.sections)
  {
    for (const Quantity* height : { &section.reinforcement, &section.height_left, &section.height_right })
    {
      told += height->measured() ? 1 : 0;
      EXPECT_TRUE(!height->measured() || std::abs(height->value - crest) < 5.0 * height->sigma)
          << "row " << section.row << ": " << height->value << " +- " << height->sigma;
    }
  }
  EXPECT_GE(told, 3 * at_least);
}
}  // namespace weld_profiler
