#include "seam_guess.h"

#include <algorithm>
#include <cmath>

#include "statistics.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr std::size_t kRows = 4;  // on either side of a place, whose median is the guess
constexpr double kNear = 3e-3;    // from the toe; the guessed line goes through the parent here ... [m]
constexpr double kFar = 10e-3;    // ... and here
}  // namespace

SeamGuess::SeamGuess(const ScanGrid& grid, const BeadTrack& track, const WeldPath& path) : grid_(grid), track_(track)
{
  std::size_t next = 0;
  for (int row = 0; row < grid.rows; ++row)
  {
    while (next + 1 < track.rows.size() &&
           std::abs(track.rows[next + 1].row - row) <= std::abs(track.rows[next].row - row))
      ++next;
    nearest_.push_back(next);
  }
  for (const RowBead& bead : track.rows)
  {
    const double y = grid.row_y[static_cast<std::size_t>(bead.row)];
    const PathPlace left = path.locate(bead.x_left, y, path.sAt(y));
    const PathPlace right = path.locate(bead.x_right, y, path.sAt(y));
    left_.push_back(Toe{ left.s, left.q });
    right_.push_back(Toe{ right.s, right.q });
  }
  const auto order = [](const Toe& a, const Toe& b) { return a.s < b.s; };
  std::sort(left_.begin(), left_.end(), order);
  std::sort(right_.begin(), right_.end(), order);
}

double SeamGuess::toe(Side side, double s) const
{
  const std::vector<Toe>& toes = side == Side::Left ? left_ : right_;
  const auto after =
      std::lower_bound(toes.begin(), toes.end(), s, [](const Toe& toe, double at) { return toe.s < at; });
  const auto at = static_cast<std::size_t>(after - toes.begin());
  const std::size_t begin = at < kRows ? 0 : std::min(at - kRows, toes.size() - std::min(toes.size(), 2 * kRows));
  std::vector<double> values;
  for (std::size_t i = begin; i < std::min(toes.size(), begin + 2 * kRows); ++i)
    values.push_back(toes[i].q);
  return median(std::move(values));
}

double SeamGuess::parentHeight(Side side, const WeldPathPoint& place, double q) const
{
  const double y = place.y + q * std::sin(place.yaw);
  const auto above = std::lower_bound(grid_.row_y.begin(), grid_.row_y.end(), y) - grid_.row_y.begin();
  const auto row = static_cast<std::size_t>(std::min<std::ptrdiff_t>(above, grid_.rows - 1));
  const RowBead& bead = track_.rows[nearest_[row]];
  return (side == Side::Left ? bead.left : bead.right).at(place.x + q * std::cos(place.yaw));
}

Line SeamGuess::parent(Side side, const WeldPathPoint& place, double toe) const
{
  const double near = toe + sign(side) * kNear;
  const double far = toe + sign(side) * kFar;
  const double height = parentHeight(side, place, near);
  const double slope = (parentHeight(side, place, far) - height) / (far - near);
  return Line{ height - slope * near, slope };
}
}  // namespace weld
}  // namespace weld_profiler
