#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "weld_profiler/core/profile.h"

namespace weld_profiler
{
/// Why a scan ended.
enum class ScanEnd
{
  Open,      ///< it has not ended
  Stopped,   ///< asked for, or the input ended
  Reversal,  ///< the stage turned round and on_reversal is split
  MaxRows    ///< max_rows reached; the next scan follows on
};

/// An organised scan: a row a placed profile in order of arrival, a column a cell.
struct Scan
{
  std::string frame_id;     ///< the cloud's frame
  std::uint32_t cells = 0;  ///< columns
  std::vector<Profile> rows;
  ScanEnd end = ScanEnd::Open;

  bool empty() const { return rows.empty(); }
};
}  // namespace weld_profiler
