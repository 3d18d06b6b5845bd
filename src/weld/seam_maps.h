#pragma once

#include "scan_grid.h"
#include "seam_surface.h"
#include "spots.h"
#include "weld_profiler/core/scan.h"
#include "weld_profiler/weld/weld_result.h"

namespace weld_profiler
{
namespace weld
{
/// What the maps of a result are filled from.
struct SeamView
{
  const Scan& scan;
  const ScanGrid& grid;
  const WeldPath& path;
  const SectionSampler& sampler;
  const SeamSections& sections;
  const SeamZones& zones;
  const Strays& strays;
  bool begins = false;  ///< the bead's first end lies within the scan
  bool ends = false;    ///< and its last
};

/// Fills labels, removal and target of a result, which are as large as the scan and say unknown, for every point of the
/// scan, filled-in ones included.
void fillMaps(const SeamView& view, const std::vector<double>& undercut_left, const std::vector<double>& undercut_right,
              const WeldParams& params, WeldResult& result);

/// How far along z the target stands above the chord of the toes: by rest_height along the chord's normal [m].
double restAbove(const Line& chord, const WeldParams& params);
}  // namespace weld
}  // namespace weld_profiler
