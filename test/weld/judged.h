#pragma once

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "weld/sections.h"
#include "weld_profiler/weld/verdict.h"

namespace weld_profiler
{
inline WeldVerdict judged(const std::vector<WeldSection>& sections, const VerdictParams& params,
                          WeldKind kind = WeldKind::Butt, const std::vector<WeldSpot>* spots = nullptr)
{
  WeldToJudge weld;
  weld.kind = kind;
  weld.sections = &sections;
  weld.spots = spots;
  return WeldJudge(params).judge(weld);
}

inline const VerdictRow& rowOf(const WeldVerdict& verdict, Imperfection imperfection, QualityLevel level)
{
  for (const VerdictRow& row : verdict.rows)
  {
    if (row.imperfection == imperfection && row.level == level)
      return row;
  }
  ADD_FAILURE() << name(imperfection) << " has no row " << name(level);
  static const VerdictRow none;
  return none;
}

/// The level C row of the undercut on a plate of 2 mm, where 0.2 mm is permitted if it is short.
inline const VerdictRow& shortRow(const WeldVerdict& verdict)
{
  return rowOf(verdict, Imperfection::Undercut, QualityLevel::C);
}

/// Undercut of this depth from s to s.
inline void cut(std::vector<WeldSection>& sections, double from_mm, double to_mm, double depth_mm = 0.12,
                Quantity WeldSection::*side = &WeldSection::undercut_left)
{
  for (WeldSection& section : sections)
  {
    if (section.s > from_mm * kMillimetre && section.s < to_mm * kMillimetre)
      (section.*side).value = depth_mm * kMillimetre;
  }
}

inline bool noted(const WeldVerdict& verdict, const std::string& words)
{
  for (const std::string& note : verdict.notes)
  {
    if (note.find(words) != std::string::npos)
      return true;
  }
  return false;
}
}  // namespace weld_profiler
