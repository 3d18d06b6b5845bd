#include "weld_profiler/weld/scan_comparison.h"

#include <cmath>

#include "compared_scans.h"
#include "ground_metal.h"
#include "over_ground.h"
#include "said.h"
#include "scan_aligner.h"
#include "scan_facets.h"
#include "statistics.h"
#include "weld_profiler/core/errors.h"
#include "weld_profiler/weld/weld_measurer.h"
#include "weld_zone.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kWholeShare = 0.995;  // a note is made of less
constexpr double kNoted = 2e-7;        // areas are noted from here [m^2]

WeldResult measureBefore(const Scan& scan, const WeldMeasurer& measurer)
{
  WeldResult result = measurer.measure(scan);
  if (!result.hasWeld() || result.measured_share == 0.0)
    throw InputError("the scan before shows no weld (" + result.reason + "), give a scan from before grinding");
  if (result.path.size() < 2)
    throw InputError("the scan before shows the weld in " + std::to_string(result.path.size()) +
                     " rows, must be two or more: scan a longer piece");
  return result;
}

double restOf(const WeldParams& params)
{
  return params.target == "rest" ? params.rest_height : 0.0;
}

double medianWidth(const WeldResult& result)
{
  std::vector<double> widths;
  for (const WeldSection& section : result.sections)
    widths.push_back(section.width.value);
  return median(std::move(widths));
}

std::string told(const ScanAlignment& aligned, const CompareParams& params)
{
  std::string given;
  const auto add = [&given](bool is_told, const std::string& what)
  {
    if (!is_told)
      given += (given.empty() ? "" : ", ") + what;
  };
  const std::string shift = said(" (1 sigma ", 1e3 * params.placement, " mm)");
  add(aligned.across_told, "the shift across the weld" + shift);
  add(aligned.along_told, "the shift along the weld" + shift);
  add(aligned.turn_told, said("the turn in the plates' plane (1 sigma ", params.placement_turn_deg, " deg)"));
  return given.empty() ? "" : "taken as the scans lie, because no surface tells it: " + given;
}

class Comparing
{
public:
  Comparing(const Scan& before, const WeldMeasurer& measurer, const CompareParams& params)
    : measurer_(measurer),
      params_(params),
      result_(measureBefore(before, measurer)),
      path_(result_.path),
      grid_(makeGrid(before)),
      maps_(gridMaps(grid_, result_)),
      distance_(distanceToWeld(grid_, maps_.labels)),
      scans_{ grid_, maps_, distance_, measurer.params().undercut_reach, restOf(measurer.params()), {}, {}, {}, {}, {} }
  {
  }

  ScanComparison operator()(const Scan& after)
  {
    lay(after);
    shareAreas(makeFacets(grid_, measurer_.params().max_gap), scans_);
    const CompareBins bins(scans_);
    const ComparedAreas areas = comparedAreas(scans_, bins, params_.over_ground_limit);
    ScanComparison comparison;
    comparison.kind = result_.kind;
    comparison.aligned = scans_.aligned;
    comparison.removed_volume = removedVolume(scans_);
    comparison.remaining_volume = remainingVolume(scans_, bins, result_.removal_volume);
    const OverGround ground = overGround(scans_, bins, path_, params_);
    comparison.over_ground = ground.spots;
    comparison.measured_share = areas.share;
    addNotes(areas, comparison);
    fillMaps(ground, comparison);
    return comparison;
  }

private:
  void lay(const Scan& after)
  {
    const ScanGrid after_grid = makeGrid(after);
    const std::vector<Facet> facets = makeFacets(after_grid, measurer_.params().max_gap);
    if (facets.empty())
      throw InputError("the scan after shows no surface (no two rows with points side by side), give another");
    const Parents parents = findParents(grid_, path_, { maps_.labels, distance_, scans_.reach, halfWidth() });
    const WeldResult bead_after = measurer_.measure(after);
    const ToeMatch toes(result_, path_, bead_after);
    const UndercutMatch undercuts(grid_, maps_, path_, parents);
    const StandingMarks marks{ toes, undercuts };
    const WeldPathPoint& middle = result_.path[result_.path.size() / 2];
    const Eigen::Vector2d along = path_.along(middle.s);
    const AlignTarget target{
      grid_, parents, { middle.x, middle.y, heightNear(middle) }, { along.x(), along.y(), 0.0 }
    };
    const SurfaceView surface{ after_grid, facets };
    ScanAligner aligner(target, surface, marks, params_);
    scans_.aligned = aligner.align();
    scans_.noise = aligner.noise();
    sampleSurface(surface, scans_.aligned.before_T_after, PlaceBins(grid_, {}), scans_.after);
  }

  double halfWidth() const
  {
    const double width = medianWidth(result_);
    return std::isfinite(width) ? 0.5 * width : 0.0;
  }

  /// Of the target in the middle of the weld, roughly: motions are told about this place.
  double heightNear(const WeldPathPoint& middle) const
  {
    std::vector<double> heights;
    for (std::size_t i = 0; i < grid_.z.size(); ++i)
      if (std::isfinite(maps_.target[i]) && distance_[i] == 0.0F &&
          std::abs(static_cast<double>(grid_.y[i]) - middle.y) < 1e-3)
        heights.push_back(static_cast<double>(maps_.target[i]));
    const double height = median(std::move(heights));
    return std::isfinite(height) ? height : 0.0;
  }

  void addNotes(const ComparedAreas& areas, ScanComparison& comparison) const
  {
    const auto note = [&comparison](std::string line)
    {
      if (!line.empty())
        comparison.notes.push_back(std::move(line));
    };
    note(told(comparison.aligned, params_));
    if (comparison.aligned.by_toes)
      note("the toes were left standing and tell how the scans lie across the weld");
    if (comparison.aligned.by_undercuts)
      note("the undercuts were left standing and tell how the scans lie along the plates");
    if (areas.share < kWholeShare)
      note(said(100.0 * (1.0 - areas.share), " % of the weld and its surroundings is missing in the scan after: the ",
                "volumes are those of the rest"));
    if (areas.low > kNoted)
      note(said(1e6 * areas.low, " mm^2 lie below the target by more than ", 1e3 * params_.over_ground_limit,
                " mm and did so before grinding (undercut, incomplete fill): not over-ground"));
    if (areas.higher > kNoted)
      note(said(1e6 * areas.higher, " mm^2 are higher after grinding than before by more than ",
                1e3 * params_.over_ground_limit, " mm: something lies there, or it is another weld"));
    if (!result_.reason.empty())
      note("scan before: " + result_.reason);
  }

  void fillMaps(const OverGround& ground, ScanComparison& comparison) const
  {
    comparison.rows = result_.rows;
    comparison.cells = result_.cells;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (std::vector<float>* map : { &comparison.after, &comparison.removed, &comparison.remaining, &comparison.spot })
      map->assign(static_cast<std::size_t>(result_.rows) * result_.cells, nan);
    for (int row = 0; row < grid_.rows; ++row)
    {
      for (int column = 0; column < grid_.cells; ++column)
      {
        const std::size_t in_grid = grid_.at(row, column);
        if (!std::isfinite(scans_.after[in_grid].z))
          continue;
        const std::size_t in_scan = grid_.inScan(row, column);
        comparison.after[in_scan] = scans_.after[in_grid].z;
        comparison.removed[in_scan] = static_cast<float>(scans_.taken(in_grid));
        comparison.remaining[in_scan] = static_cast<float>(scans_.above(in_grid));
        if (std::isfinite(comparison.remaining[in_scan]))
          comparison.spot[in_scan] = static_cast<float>(ground.of[in_grid]);
      }
    }
  }

  const WeldMeasurer& measurer_;
  const CompareParams& params_;
  const WeldResult result_;
  const PathFrame path_;
  const ScanGrid grid_;
  const GridMaps maps_;
  const std::vector<float> distance_;
  ComparedScans scans_;
};
}  // namespace
}  // namespace weld

ScanComparer::ScanComparer(const WeldParams& measuring, const CompareParams& params)
  : measuring_(measuring), params_(params)
{
  measuring_.validate();
  params_.validate();
}

ScanComparison ScanComparer::compare(const Scan& before, const Scan& after) const
{
  const WeldMeasurer measurer(measuring_);
  return weld::Comparing(before, measurer, params_)(after);
}
}  // namespace weld_profiler
