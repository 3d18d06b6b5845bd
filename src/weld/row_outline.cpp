#include "row_outline.h"

#include <algorithm>
#include <cmath>

#include "statistics.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kCorner = 0.546;     // tangent of the angle from which parents make a corner: 0.5 rad
constexpr double kNoiseSigmas = 4.0;  // a node stands out from its parent
constexpr double kSeen = 2e-5;        // ... by at least this [m]
constexpr double kWallHeight = 5e-4;  // of an upright wall [m]
constexpr double kWallReach = 8e-4;   // it is looked for this far from the toe [m]
constexpr double kWallStep = 2.5e-4;  // from one cell to the next [m]

bool corner(const RowBead& bead)
{
  const double turn = 1.0 + bead.left.slope * bead.right.slope;  // times its tangent: the difference of the slopes
  const double rise = bead.right.slope - bead.left.slope;
  return turn > 0.0 ? rise > kCorner * turn : rise > 0.0;
}
}  // namespace

RowOutline::RowOutline(const ScanGrid& grid, int row) : grid_(grid), row_(row), nodes_(rowNodes(grid, row))
{
  noise_ = nodeNoise(nodes_);
  seen_ = std::max(kSeen, kNoiseSigmas * noise_);
}

int RowOutline::firstOff(int from, int end, const Line& line, double width) const
{
  const int step = end > from ? 1 : -1;
  int first = end;
  for (int i = from; i != end; i += step)
  {
    if (!(std::abs(line.above(node(i).x, node(i).z)) > seen_))
    {
      first = end;
      continue;
    }
    first = first == end ? i : first;
    if (std::abs(node(i).x - node(first).x) >= width)
      return first;
  }
  return end;
}

void RowOutline::setToes(int first, int last, RowBead& bead) const
{
  bead.x_left = 0.5 * (node(first).x + node(std::max(0, first - 1)).x);
  bead.x_right = 0.5 * (node(last).x + node(std::min(size() - 1, last + 1)).x);
}

int RowOutline::highest(int first, int last, const RowBead& bead) const
{
  int top = first;
  for (int i = first; i <= last; ++i)
  {
    if (node(i).z - reference(bead, node(i).x) > node(top).z - reference(bead, node(top).x))
      top = i;
  }
  return top;
}

int RowOutline::footOf(int top, int end, const Line& line, const RowBead& bead) const
{
  const int step = end > top ? 1 : -1;
  const auto low = [&](int i)
  { return std::max(line.above(node(i).x, node(i).z), node(i).z - reference(bead, node(i).x)) <= seen_; };
  int i = top;
  while (i != end && !(low(i + step) && (i + step == end || low(i + 2 * step))))
    i += step;
  return i;
}

double reference(const RowBead& bead, double x)
{
  if (!bead.whole())
    return bead.left.valid() ? bead.left.at(x) : bead.right.at(x);
  if (corner(bead))
    return std::max(bead.left.at(x), bead.right.at(x));
  const double share = (x - bead.x_left) / (bead.x_right - bead.x_left);
  return bead.left.at(bead.x_left) + share * (bead.right.at(bead.x_right) - bead.left.at(bead.x_left));
}

double RowOutline::sumUp(int first, int last, RowBead& bead) const
{
  int above = 0;
  for (int i = first; i <= last; ++i)
  {
    const double rise = node(i).z - reference(bead, node(i).x);
    const double step = 0.5 * (node(std::min(last, i + 1)).x - node(std::max(first, i - 1)).x);
    bead.height = std::max(bead.height, rise);
    bead.area += rise * step;
    above += rise > 0.0 ? 1 : 0;
  }
  return static_cast<double>(above) / (last - first + 1);
}

bool RowOutline::wall(double x) const
{
  const auto near = std::lower_bound(nodes_.begin(), nodes_.end(), x - kWallReach,
                                     [](const Node& node, double at) { return node.x < at; });
  double last_x = kNaN, last_z = kNaN;
  const int first = near == nodes_.begin() ? 0 : (near - 1)->cell;
  for (int cell = first; cell < grid_.cells; ++cell)
  {
    const std::size_t i = grid_.at(row_, cell);
    if (!std::isfinite(grid_.z[i]) || grid_.x[i] < x - kWallReach)
      continue;
    if (grid_.x[i] > x + kWallReach)
      break;
    const double rise = std::abs(grid_.z[i] - last_z);
    const double run = std::abs(grid_.x[i] - last_x);
    if ((rise > kWallStep && run < 1.5 * grid_.spacing) || (rise > kWallHeight && rise > 4.0 * run))
      return true;
    last_x = grid_.x[i], last_z = grid_.z[i];
  }
  return false;
}
}  // namespace weld
}  // namespace weld_profiler
