#pragma once

#include <vector>

#include "weld_profiler/weld/verdict.h"

namespace weld_profiler
{
constexpr double kMillimetre = 1e-3;
constexpr double kDegree = 3.14159265358979323846 / 180.0;

/// A flawless butt weld's section, 12 mm wide and 1 mm high, each value known to 10 um (angles to 1 deg).
inline WeldSection goodSection(double s = 0.0)
{
  WeldSection section;
  const double sigma = 1e-5;
  section.s = s;
  section.width = { 12e-3, sigma };
  section.reinforcement = { 1e-3, sigma };
  section.height_left = section.height_right = section.reinforcement;
  section.toe_angle_left = section.toe_angle_right = { 160.0 * kDegree, kDegree };
  section.undercut_left = section.undercut_right = { 0.0, sigma };
  section.misalignment = { 0.0, sigma };
  section.incomplete_fill = { 0.0, sigma };
  section.area = { 8e-6, 1e-7 };
  section.throat = { 5e-3, sigma };
  return section;
}

/// Flawless sections of a weld of this length: each stands for a step, the first half a step from its end.
inline std::vector<WeldSection> goodWeld(double length, double step = 0.25e-3)
{
  std::vector<WeldSection> sections;
  const int count = static_cast<int>(length / step + 0.5);
  for (int i = 0; i < count; ++i)
  {
    sections.push_back(goodSection((i + 0.5) * step));
    sections.back().section = i;
  }
  return sections;
}

/// Judged with this plate thickness [mm].
inline VerdictParams plate(double thickness_mm)
{
  VerdictParams params;
  params.thickness = thickness_mm * kMillimetre;
  return params;
}
}  // namespace weld_profiler
