#pragma once

#include "kind_model.h"

namespace weld_profiler
{
namespace weld
{
const KindModel& buttModel();
const KindModel& filletModel();
const KindModel& beadOnPlateModel();
}  // namespace weld
}  // namespace weld_profiler
