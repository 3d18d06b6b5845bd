#pragma once

#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/csv_fields.h"
#include "weld/sections.h"
#include "weld_profiler/weld/weld_csv.h"

namespace weld_profiler
{
inline std::string written(const std::vector<WeldRecord>& records)
{
  std::ostringstream out;
  writeWeldCsv(records, out);
  return out.str();
}

inline WeldRecord fullRecord()
{
  WeldRecord record;
  record.section = goodSection(0.0123456);
  WeldSection& section = record.section;
  section.section = 7;
  section.row = 12;
  section.stage = -0.25;
  section.yaw = -0.1;
  section.toe_left = { { -6e-3, 1e-6 }, { 2e-3, 2e-6 }, { 0.3e-3, 3e-6 } };
  section.toe_right = { { 6e-3, 4e-6 }, { 2.1e-3, 5e-6 }, { -0.4e-3, 6e-6 } };
  section.leg_left = { 6e-3, 1e-5 };
  section.leg_right = { 7e-3, 2e-5 };
  section.angle = { 0.02, 0.001 };
  section.reference = SectionReference::ParentLines;
  record.verdict = "C";
  record.unverified = true;
  return record;
}

inline std::string replaced(std::string text, const std::string& from, const std::string& to)
{
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}
}  // namespace weld_profiler
