#include "weld_profiler/weld/live_weld.h"

#include "measuring.h"

namespace weld_profiler
{
WeldSection LiveWeld::measure(const Profile& profile)
{
  const weld::ScanGrid grid = weld::makeGrid(profile);
  WeldSection section =
      weld::measureOneRow(grid, yaw_.at(grid.rows > 0 ? grid.row_y.front() : 0.0), measurer_.params());
  section.stage = profile.stage;
  yaw_.add(0.5 * (section.toe_left.x.value + section.toe_right.x.value),
           0.5 * (section.toe_left.y.value + section.toe_right.y.value));
  return section;
}
}  // namespace weld_profiler
