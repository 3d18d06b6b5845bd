#include "bead_tracks.h"

#include <algorithm>

#include "statistics.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kLongestBreak = 2e-3;  // in y between two rows of a track [m]
constexpr double kAlike = 0.6;          // common width over joint width of neighbours
constexpr double kHalfSeen = 0.2;       // weight of a bead with one parent in view

/// Common width over joint width.
double likeness(const RowBead& a, const RowBead& b)
{
  const double common = std::min(a.x_right, b.x_right) - std::max(a.x_left, b.x_left);
  return common / (std::max(a.x_right, b.x_right) - std::min(a.x_left, b.x_left));
}

/// Number of the track that a finding goes on with, or that of none.
std::size_t trackOf(const ScanGrid& grid, const RowBead& bead, const std::vector<BeadTrack>& tracks)
{
  std::size_t best = tracks.size();
  double most = kAlike;
  for (std::size_t t = 0; t < tracks.size(); ++t)
  {
    const RowBead& last = tracks[t].rows.back();
    const double gap = grid.row_y[static_cast<std::size_t>(bead.row)] - grid.row_y[static_cast<std::size_t>(last.row)];
    if (last.row == bead.row || (gap > kLongestBreak && bead.row - last.row > 2))
      continue;
    const double common = likeness(last, bead);
    if (!(common > most))
      continue;
    most = common;
    best = t;
  }
  return best;
}
}  // namespace

double BeadTrack::width() const
{
  std::vector<double> values;
  for (const RowBead& bead : rows)
    values.push_back(bead.x_right - bead.x_left);
  return median(std::move(values));
}

double BeadTrack::height() const
{
  std::vector<double> values;
  for (const RowBead& bead : rows)
    values.push_back(bead.height);
  return median(std::move(values));
}

std::vector<BeadTrack> trackBeads(const ScanGrid& grid, const std::vector<RowFindings>& findings, int min_rows)
{
  std::vector<BeadTrack> tracks;
  for (const RowFindings& row : findings)
  {
    for (const RowBead& bead : row.beads)
    {
      const std::size_t t = trackOf(grid, bead, tracks);
      if (t == tracks.size())
        tracks.emplace_back();
      tracks[t].rows.push_back(bead);
      tracks[t].strength += bead.area * (bead.whole() ? 1.0 : kHalfSeen);
    }
  }
  tracks.erase(
      std::remove_if(tracks.begin(), tracks.end(),
                     [min_rows](const BeadTrack& track) { return static_cast<int>(track.rows.size()) < min_rows; }),
      tracks.end());
  std::stable_sort(tracks.begin(), tracks.end(),
                   [](const BeadTrack& a, const BeadTrack& b) { return a.strength > b.strength; });
  return tracks;
}
}  // namespace weld
}  // namespace weld_profiler
