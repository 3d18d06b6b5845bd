#pragma once

#include <nodelet/nodelet.h>

#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
/// Runs a nodelet's start and says why it failed: the manager swallows an exception's text and only refuses the load.
/// Use inside onInit of a nodelet.
template <class Start>
void startOrExplain(const std::string& name, Start&& start)
{
  try
  {
    start();
  }
  catch (const std::exception& error)
  {
    ROS_FATAL_STREAM_NAMED(name, "[" << name << "] " << error.what());
    throw;
  }
}
}  // namespace weld_profiler
