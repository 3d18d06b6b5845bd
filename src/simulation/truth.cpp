#include "simulation/truth.h"

#include <algorithm>
#include <cmath>

namespace weld_profiler
{
namespace simulation
{
namespace
{
constexpr double kPi = 3.141592653589793;

/// One crossing of a cell by the sheet's image.
struct Crossing
{
  CutPoint point;
  bool clear = false;  ///< lit and seen
};

/// t between two points of the cut at which its image crosses a cell's centre.
bool solve(const SheetCut& cut, const CutPoint& a, const CutPoint& b, double cell, CutPoint& found)
{
  constexpr int kIterations = 40;
  constexpr double kSettled = 1e-8;  // [px]
  found.position.z() = a.position.z();
  double low = a.t, high = b.t;
  double low_error = a.pixel.cell - cell, high_error = b.pixel.cell - cell;
  for (int i = 0; i < kIterations; ++i)
  {
    // secant step, halved now and then so that the bracket is sure to close
    const double share = i % 4 == 3 ? 0.5 : low_error / (low_error - high_error);
    if (!cut.at(low + share * (high - low), found))
      return false;
    const double error = found.pixel.cell - cell;
    if (std::abs(error) < kSettled)
      return true;
    if ((error < 0.0) == (low_error < 0.0))
      low = found.t, low_error = error;
    else
      high = found.t, high_error = error;
  }
  return true;
}

std::vector<std::vector<Crossing>> crossings(const SheetCut& cut)
{
  const std::vector<CutPoint> points = cut.trace();
  std::vector<std::vector<Crossing>> cells(static_cast<std::size_t>(cut.cells()));
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
  {
    const CutPoint& a = points[i];
    const CutPoint& b = points[i + 1];
    if (!a.joined || a.pixel.cell == b.pixel.cell)
      continue;
    const int last = static_cast<int>(std::ceil(std::max(a.pixel.cell, b.pixel.cell))) - 1;
    const int first = static_cast<int>(std::ceil(std::min(a.pixel.cell, b.pixel.cell)));
    for (int cell = std::max(0, first); cell <= std::min(last, cut.cells() - 1); ++cell)
    {
      Crossing crossing;
      crossing.clear = a.lit && a.seen && b.lit && b.seen;
      if (solve(cut, a, b, cell, crossing.point))
        cells[static_cast<std::size_t>(cell)].push_back(crossing);
    }
  }
  return cells;
}

/// Direction across the stripe's image, from +u toward +v, in (-pi/2, pi/2].
double normalAngle(const SheetCut& cut, const CutPoint& centre)
{
  constexpr double kStep = 2e-6;  // [m]
  CutPoint before = centre;
  CutPoint after = centre;
  if (!cut.at(centre.t - kStep, before) || !cut.at(centre.t + kStep, after))
    return 0.5 * kPi;
  const Eigen::Vector2d along = cut.raw(after.pixel) - cut.raw(before.pixel);
  double angle = std::atan2(along.x(), -along.y());
  if (angle > 0.5 * kPi)
    angle -= kPi;
  if (angle <= -0.5 * kPi)
    angle += kPi;
  return angle;
}

/// Does the surface jump at t while the shutter is open? Then the image shows two stripes or none that is right.
bool jumps(const std::vector<SheetCut>& ends, const CutPoint& middle)
{
  constexpr double kJumpPx = 1.0;
  for (const SheetCut& end : ends)
  {
    CutPoint point = middle;
    if (!end.at(middle.t, point) || std::abs(point.pixel.across - middle.pixel.across) > kJumpPx)
      return true;
  }
  return false;
}
TruthCentre centre(const SheetCut& cut, const std::vector<SheetCut>& ends, int cell, const std::vector<Crossing>& found)
{
  const auto isClear = [](const Crossing& crossing) { return crossing.clear; };
  const auto clear = std::find_if(found.begin(), found.end(), isClear);
  const CutPoint& chosen = clear == found.end() ? found.front().point : clear->point;
  TruthCentre result;
  result.cell = static_cast<std::uint16_t>(cell);
  const Eigen::Vector2d raw = cut.raw(chosen.pixel);
  result.u = raw.x();
  result.v = raw.y();
  result.normal_angle = normalAngle(cut, chosen);
  result.x = chosen.position.x();
  result.y = chosen.position.y();
  result.z = chosen.position.z();
  const double across = chosen.pixel.across;
  result.visible = std::count_if(found.begin(), found.end(), isClear) == 1 && across >= 0.0 &&
                   across <= cut.acrossPixels() - 1.0 && !jumps(ends, chosen);
  return result;
}
}  // namespace

std::vector<TruthCentre> trueCentres(const World& world, int frame)
{
  const double middle = world.frameTime(frame);
  const SheetCut cut = world.cut(middle);
  std::vector<SheetCut> ends;
  if (world.scene.motion_blur && world.scene.exposure > 0.0)
    for (const double half : { -0.5, 0.5 })
      ends.push_back(world.cut(middle + half * world.scene.exposure));
  const auto cells = crossings(cut);
  std::vector<TruthCentre> result;
  result.reserve(cells.size());
  for (std::size_t cell = 0; cell < cells.size(); ++cell)
    if (!cells[cell].empty())
      result.push_back(centre(cut, ends, static_cast<int>(cell), cells[cell]));
  return result;
}
}  // namespace simulation
}  // namespace weld_profiler
