#include "weld_profiler/weld/weld_measurer.h"

#include "measuring.h"
#include "weld_profiler/core/errors.h"

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

WeldSection WeldMeasurer::measureRow(const Profile& profile, const Quantity& yaw) const
{
  if (!yaw.measured() || yaw.sigma < 0.0)
    throw PreconditionError("yaw and its sigma must be numbers");
  WeldSection section = weld::measureOneRow(weld::makeGrid(profile), yaw, params_);
  section.stage = profile.stage;
  return section;
}
}  // namespace weld_profiler
