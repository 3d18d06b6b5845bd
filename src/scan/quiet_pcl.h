#pragma once

#include <pcl/console/print.h>

namespace weld_profiler
{
/// While it lives PCL prints nothing: what goes wrong is told once, by our exception.
class QuietPcl
{
public:
  QuietPcl() : level_(pcl::console::getVerbosityLevel()) { pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS); }
  ~QuietPcl() { pcl::console::setVerbosityLevel(level_); }
  QuietPcl(const QuietPcl&) = delete;
  QuietPcl& operator=(const QuietPcl&) = delete;

private:
  pcl::console::VERBOSITY_LEVEL level_;
};
}  // namespace weld_profiler
