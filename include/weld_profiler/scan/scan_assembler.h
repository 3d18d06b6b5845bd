#pragma once

#include <optional>
#include <string>

#include "weld_profiler/core/scan.h"
#include "weld_profiler/scan/scan_params.h"

namespace weld_profiler
{
/// Placed profiles -> organised scans: trigger, reversal, max_rows. Not thread safe.
class ScanAssembler
{
public:
  enum class Outcome
  {
    Row,      ///< the profile became a row
    Skipped   ///< the stage had not moved far enough
  };
  struct Result
  {
    Outcome outcome = Outcome::Skipped;
    std::optional<Scan> ended;  ///< a scan that this profile closed (reversal, max_rows, another width)
  };

  /// @throws ConfigError as ScanParams::validate.
  ScanAssembler(const ScanParams& params, std::string frame_id);

  Result add(const Profile& profile);

  /// Closes the open scan; empty when it has no row.
  Scan close(ScanEnd end);

  const Scan& open() const { return scan_; }

private:
  ScanParams params_;
  std::string frame_id_;
  Scan scan_;
  // where the stage was at the last row and at its furthest, and which way it went: for trigger and reversal
  double last_row_stage_ = 0.0;
  double furthest_stage_ = 0.0;
  int heading_ = 0;
};
}  // namespace weld_profiler
