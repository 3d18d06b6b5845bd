#pragma once

#include <optional>
#include <string>

#include "weld_profiler/core/scan.h"
#include "weld_profiler/scan/scan_params.h"

namespace weld_profiler
{
/// Placed profiles -> organised scans: trigger, reversal, max_rows. Not thread safe.
///
/// With on_reversal split a `distance` row lies beyond all rows before it in the direction of travel: on the way back
/// nothing becomes a row until reversal_hysteresis is covered; there the next scan begins. The direction of travel is
/// known once the stage has moved by reversal_hysteresis. Rows without points take the width of their scan.
class ScanAssembler
{
public:
  enum class Outcome
  {
    Row,     ///< the profile became a row
    Skipped  ///< the stage had not moved far enough
  };
  struct Result
  {
    Outcome outcome = Outcome::Skipped;
    std::optional<Scan> ended;  ///< a scan that this profile closed (reversal, max_rows, another width)
  };

  /// @throws ConfigError as ScanParams::validate.
  ScanAssembler(const ScanParams& params, std::string frame_id);

  Result add(const Profile& profile);

  /// Closes the open scan; empty when it has no row. The next profile is a row and begins the next scan.
  Scan close(ScanEnd end);

  /// Other settings from the next profile on; the open scan goes on. @throws ConfigError; the old ones stay.
  void use(const ScanParams& params);

  const Scan& open() const { return scan_; }

private:
  bool reversed(double stage);
  bool triggered(double stage) const;
  bool fits(const Profile& profile) const;
  void append(const Profile& profile);
  Scan takeScan(ScanEnd end);

  ScanParams params_;
  std::string frame_id_;
  Scan scan_;
  bool width_known_ = false;  ///< a row of the open scan has points
  // where the stage was at the last row, how far it came either way, and which way it goes: for trigger and reversal
  bool started_ = false;
  double last_row_stage_ = 0.0;
  double lowest_stage_ = 0.0;
  double highest_stage_ = 0.0;
  int heading_ = 0;
};
}  // namespace weld_profiler
