#include "weld_profiler/ros/diagnostics.h"

namespace weld_profiler
{
void reportAge(const AgeStatistics::Summary& age, diagnostic_updater::DiagnosticStatusWrapper& status)
{
  status.addf("rate [Hz]", "%.2f", age.rate);
  status.addf("age p50 [ms]", "%.3f", 1e3 * age.p50);
  status.addf("age p99 [ms]", "%.3f", 1e3 * age.p99);
  status.addf("age max [ms]", "%.3f", 1e3 * age.max);
}

void reportBalance(const FrameBalance& balance, std::size_t waiting,
                   diagnostic_updater::DiagnosticStatusWrapper& status)
{
  using diagnostic_msgs::DiagnosticStatus;
  status.add("frames in", balance.frames_in);
  status.add("rows", balance.rows);
  status.add("no stripe", balance.no_stripe);
  status.add("skipped", balance.skipped);
  status.add("waiting", waiting);
  status.add("unplaced", balance.unplacedTotal());
  for (const auto& reason : balance.unplaced)
    status.add("unplaced " + reason.first, reason.second);
  status.add("dropped", balance.droppedTotal());
  for (const auto& reason : balance.dropped)
    status.add("dropped " + reason.first, reason.second);
  if (balance.frames_in == 0)
    status.mergeSummary(DiagnosticStatus::WARN, "no frames");
  if (balance.droppedTotal() > 0)
    status.mergeSummary(DiagnosticStatus::WARN, "frames dropped");
  if (balance.unplacedTotal() > 0)
    status.mergeSummary(DiagnosticStatus::WARN, "frames unplaced");
}
}  // namespace weld_profiler
