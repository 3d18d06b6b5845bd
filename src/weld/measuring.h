#pragma once

#include <memory>
#include <vector>

#include "scan_grid.h"
#include "seam_sections.h"
#include "spots.h"
#include "weld_finder.h"
#include "weld_profiler/weld/weld_params.h"
#include "weld_profiler/weld/weld_result.h"

namespace weld_profiler
{
namespace weld
{
/// One scan on its way from points to a WeldResult:
/// rows -> bead and path -> sections -> a better path, strays -> sections again -> kind, values, maps.
class Measuring
{
public:
  Measuring(const Scan& scan, const WeldParams& params) : scan_(scan), params_(params) {}

  WeldResult operator()();

private:
  void measureRoughly();
  void measureFinally();
  bool chooseKind(WeldResult& result) const;
  void fillSections(WeldResult& result);
  void fillResultMaps(WeldResult& result) const;
  bool standsOutEnough(std::size_t sections) const;
  void sayWhatIsMissing(WeldResult& result) const;
  std::vector<double> sectionPlaces(const WeldPath& path, double step) const;
  WeldPath refinedPath(const SeamSections& sections) const;

  const Scan& scan_;
  const WeldParams& params_;
  WeldParams blurred_;  ///< with the blur of this scan's rows
  ScanGrid grid_;
  FoundWeld found_;
  std::unique_ptr<const WeldPath> path_;
  std::unique_ptr<const SectionSampler> sampler_;
  std::unique_ptr<const SeamGuess> guess_;
  std::unique_ptr<SeamSections> sections_;
  Strays strays_;
  int standing_out_ = 0;                                ///< sections in which a bead rises beyond doubt
  bool path_doubtful_ = false;                          ///< a width was refused for the path's direction
  std::vector<double> undercut_left_, undercut_right_;  ///< width of each section's undercuts [m]
};

/// One section from a grid of one row.
WeldSection measureOneRow(const ScanGrid& grid, const Quantity& yaw, const WeldParams& params);
}  // namespace weld
}  // namespace weld_profiler
