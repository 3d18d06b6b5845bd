#include "weld_shape.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "scan_grid.h"
#include "statistics.h"
#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kBridge = 2e-3;   // toes are connected over this much at least [m]
constexpr double kPerStep = 1.5;   // radius of what a vertex is told from, in steps of the mesh
constexpr double kPerPitch = 1.5;  // and in rows of the scan
constexpr double kPerGap = 0.6;    // and in widths of gaps that it has to reach across

void requireSame(const Scan& scan, const WeldResult& result)
{
  const std::size_t count = scan.rows.size() * scan.cells;
  if (result.rows != scan.rows.size() || result.cells != scan.cells || result.labels.size() != count ||
      result.target.size() != count)
    throw PreconditionError("the weld was measured in a scan of " + std::to_string(result.rows) + " x " +
                            std::to_string(result.cells) + " points, this one has " + std::to_string(scan.rows.size()) +
                            " x " + std::to_string(scan.cells));
  if (result.path.size() != result.sections.size())
    throw PreconditionError("the weld's path has " + std::to_string(result.path.size()) + " points for " +
                            std::to_string(result.sections.size()) + " sections, must be one each");
}

/// The points of a scan, each to the surfaces that it is part of.
struct Sorter
{
  const PathFrame& frame;
  const ToeTrack& toes;
  double beside;  ///< points further than this outside the toes are of no interest [m]
  double beyond;  ///< nor are those further than this before the first toes or behind the last [m]
  std::vector<HeightPoint> bead, target_between, target_beside;

  void operator()(const PathPlace& place, double z, WeldLabel label, double target)
  {
    const double first = toes.pairs().front().s, last = toes.pairs().back().s;
    const double s = std::min(std::max(place.s, first), last);
    if (std::abs(place.s - s) > beyond || !toes.has(s))
      return;
    const ToePair pair = toes.at(s);
    if (place.q < pair.left - beside || place.q > pair.right + beside)
      return;
    const bool inside = place.q >= pair.left && place.q <= pair.right;
    if (label == WeldLabel::Bead || (inside && label == WeldLabel::Spatter))
      bead.push_back({ place.s, place.q, z });
    if (std::isfinite(target))
      (inside ? target_between : target_beside).push_back({ place.s, place.q, target });
  }
};

void sortPoints(const ScanGrid& grid, const WeldResult& result, Sorter& sorter)
{
  double near_s = result.path.front().s;
  for (int row = 0; row < grid.rows; ++row)
  {
    for (int column = 0; column < grid.cells; ++column)
    {
      const std::size_t i = grid.at(row, column);
      if (!std::isfinite(grid.z[i]))
        continue;
      const std::size_t at = grid.inScan(row, column);
      const double target = static_cast<double>(result.target[at]);
      const auto label = static_cast<WeldLabel>(result.labels[at]);
      if (!std::isfinite(target) && label != WeldLabel::Bead)
        continue;
      const PathPlace place =
          sorter.frame.locate(static_cast<double>(grid.x[i]), static_cast<double>(grid.y[i]), near_s);
      near_s = place.s;
      sorter(place, static_cast<double>(grid.z[i]), label, target);
    }
  }
}

/// How far rows lie apart along the path, where it is most oblique.
double pitchAlong(const ScanGrid& grid, const WeldResult& result)
{
  double least = 1.0;
  for (const WeldPathPoint& point : result.path)
    least = std::min(least, std::abs(std::cos(point.yaw)));
  return grid.pitch / std::max(least, 0.1);
}
}  // namespace

WeldShape::WeldShape(const Scan& scan, const WeldResult& result, const WeldSurfaceParams& params)
{
  if (!result.hasWeld())
  {
    reason_ = result.reason.empty() ? "the scan shows no weld" : result.reason;
    return;
  }
  requireSame(scan, result);
  corner_ = result.kind == WeldKind::Fillet;
  reason_ = findPath(result);
  if (reason_.empty())
    reason_ = findSurfaces(scan, result, params);
}

std::string WeldShape::findPath(const WeldResult& result)
{
  if (result.path.size() < 2)
    return "the weld has " + std::to_string(result.path.size()) + (result.path.empty() ? " sections" : " section") +
           ", a surface takes two or more: take a smaller section_step, or 0 for a section a row";
  frame_ = std::make_unique<PathFrame>(result.path);
  std::vector<double> steps;
  for (std::size_t i = 1; i < result.path.size(); ++i)
    steps.push_back(result.path[i].s - result.path[i - 1].s);
  toes_ = std::make_unique<ToeTrack>(result, *frame_, std::max(kBridge, kPerPitch * median(std::move(steps))));
  if (toes_->pairs().size() < 2)
    return "both toes were measured in " + std::to_string(toes_->pairs().size()) +
           " sections, a surface takes two or more";
  return "";
}

std::string WeldShape::findSurfaces(const Scan& scan, const WeldResult& result, const WeldSurfaceParams& params)
{
  const ScanGrid grid = makeGrid(scan);
  const double pitch = pitchAlong(grid, result);
  constexpr double kRounding = 1.0 + 1e-4;
  if (!(pitch <= kRounding * params.max_gap))
  {
    std::ostringstream text;
    text << "rows of the scan lie " << 1e3 * pitch << " mm apart along the weld, more than max_gap ("
         << 1e3 * params.max_gap << " mm)";
    return text.str();
  }
  const double radius = std::max({ kPerStep * params.mesh_step, kPerPitch * pitch, kPerGap * params.max_gap });
  Sorter sorter{ *frame_, *toes_, params.target_margin + 2.0 * radius, radius, {}, {}, {} };
  sortPoints(grid, result, sorter);
  const double reach = 0.5 * params.max_gap;
  bead_ = std::make_unique<LocalSurface>(sorter.bead, radius, reach);
  between_ = std::make_unique<LocalSurface>(sorter.target_between, radius, reach);
  beside_ = std::make_unique<LocalSurface>(sorter.target_beside, radius, reach);
  return "";
}
}  // namespace weld
}  // namespace weld_profiler
