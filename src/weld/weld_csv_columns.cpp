#include "weld_csv_columns.h"

namespace weld_profiler
{
const std::vector<MeasuredColumn>& measuredColumns()
{
  using S = WeldSection;
  static const std::vector<MeasuredColumn> columns = {
    { "width_mm", kMm, [](S& s) -> Quantity& { return s.width; } },
    { "reinforcement_mm", kMm, [](S& s) -> Quantity& { return s.reinforcement; } },
    { "toe_left_x_mm", kMm, [](S& s) -> Quantity& { return s.toe_left.x; } },
    { "toe_right_x_mm", kMm, [](S& s) -> Quantity& { return s.toe_right.x; } },
    { "toe_angle_left_deg", kDeg, [](S& s) -> Quantity& { return s.toe_angle_left; } },
    { "toe_angle_right_deg", kDeg, [](S& s) -> Quantity& { return s.toe_angle_right; } },
    { "undercut_left_mm", kMm, [](S& s) -> Quantity& { return s.undercut_left; } },
    { "undercut_right_mm", kMm, [](S& s) -> Quantity& { return s.undercut_right; } },
    { "misalignment_mm", kMm, [](S& s) -> Quantity& { return s.misalignment; } },
    { "area_mm2", kMm2, [](S& s) -> Quantity& { return s.area; } },
    { "toe_left_y_mm", kMm, [](S& s) -> Quantity& { return s.toe_left.y; } },
    { "toe_left_z_mm", kMm, [](S& s) -> Quantity& { return s.toe_left.z; } },
    { "toe_right_y_mm", kMm, [](S& s) -> Quantity& { return s.toe_right.y; } },
    { "toe_right_z_mm", kMm, [](S& s) -> Quantity& { return s.toe_right.z; } },
    { "leg_left_mm", kMm, [](S& s) -> Quantity& { return s.leg_left; } },
    { "leg_right_mm", kMm, [](S& s) -> Quantity& { return s.leg_right; } },
    { "throat_mm", kMm, [](S& s) -> Quantity& { return s.throat; } },
    { "height_left_mm", kMm, [](S& s) -> Quantity& { return s.height_left; } },
    { "height_right_mm", kMm, [](S& s) -> Quantity& { return s.height_right; } },
  };
  return columns;
}

const std::vector<MeasuredColumn>& laterColumns()
{
  static const std::vector<MeasuredColumn> columns = {
    { "angle_deg", kDeg, [](WeldSection& s) -> Quantity& { return s.angle; } },
    { "incomplete_fill_mm", kMm, [](WeldSection& s) -> Quantity& { return s.incomplete_fill; } },
  };
  return columns;
}

const std::vector<std::string>& verdictWords()
{
  static const std::vector<std::string> words = { "", "B", "C", "D", "fail", "undecided" };
  return words;
}

const std::vector<std::string>& referenceWords()
{
  static const std::vector<std::string> words = { "chord", "parent_lines" };
  return words;
}

const std::vector<std::string>& sourceWords()
{
  static const std::vector<std::string> words = { "", "read", "unverified" };
  return words;
}
}  // namespace weld_profiler
