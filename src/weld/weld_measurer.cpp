#include "weld_profiler/weld/weld_measurer.h"

#include "measuring.h"

namespace weld_profiler
{
WeldMeasurer::WeldMeasurer(const WeldParams& params) : params_(params)
{
  params_.validate();
}

WeldResult WeldMeasurer::measure(const Scan& scan) const
{
  return weld::Measuring(scan, params_)();
}

WeldSection WeldMeasurer::measureRow(const Profile& profile, double yaw) const
{
  WeldSection section = weld::measureOneRow(weld::makeGrid(profile), yaw, params_);
  section.stage = profile.stage;
  return section;
}
}  // namespace weld_profiler
