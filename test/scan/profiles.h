#pragma once

#include <cstdint>

#include "weld_profiler/core/profile.h"

/// A placed profile with one point a cell given, at z = stage.
inline weld_profiler::Profile profileAt(double stage, std::uint32_t cells = 4, int points = 2)
{
  weld_profiler::Profile profile;
  profile.stamp = 1000000000;
  profile.stage = stage;
  profile.cells = cells;
  for (int i = 0; i < points; ++i)
    profile.points.push_back({ 0.001F * static_cast<float>(i), 0.0F, static_cast<float>(stage), 50.0F, 1e-5F,
                               static_cast<std::uint16_t>(i), 0 });
  return profile;
}
