#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bead_tracks.h"
#include "weld_path.h"
#include "weld_profiler/weld/weld_params.h"

namespace weld_profiler
{
namespace weld
{
constexpr double kRowToeSigma = 1.5e-4;  ///< of a toe as a row shows it [m]
constexpr double kPathReach = 0.03;      ///< a path goes on beyond the bead's ends, so that every point has a place [m]

/// The weld of a scan as the rows show it, and what else they show.
struct FoundWeld
{
  BeadTrack track;                       ///< the strongest bead and what goes on along its path (tack welds)
  std::shared_ptr<const WeldPath> path;  ///< null = no weld
  double from_y = 0.0, to_y = 0.0;       ///< where the bead begins and ends
  std::vector<OtherBead> others;
  std::string reason;  ///< why there is none
};

FoundWeld findWeld(const ScanGrid& grid, const WeldParams& params);
}  // namespace weld
}  // namespace weld_profiler
