#include "weld_finder.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <sstream>

#include "statistics.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr int kFewestRows = 3;
constexpr int kEnoughRows = 40;  // with more, those at least kRowStep apart are looked at [m]
constexpr double kRowStep = 2e-4;
constexpr std::size_t kFewestToTell = 10;  // rows, of a shape
constexpr double kHighEnough = 3e-4;       // to tell it from [m]
constexpr double kWidening = 1.7;          // of a bead's width in its middle: more is none
constexpr double kHeapLength = 1.5;        // in widths
constexpr double kHeapRise = 1.7;          // of the height in its middle
constexpr double kToTheEnd = 1e-3;         // a bead seen this near to the scan's end goes on to it [m]
constexpr double kAsWide = 0.5;            // of two pieces of one weld
constexpr double kAround = 8e-3;           // rows this near in y tell how wide a bead is [m]
constexpr double kOddShare = 0.25;         // a row's bead differs from them by more than this share
constexpr double kOddWidth = 5e-4;         // ... and more than this [m]
constexpr double kOnPath = 0.3;            // of the width: a bead this near to the path goes on along it

WeldPath pathOf(const ScanGrid& grid, const BeadTrack& track)
{
  std::vector<PathSample> samples;
  for (const RowBead& bead : track.rows)
    samples.push_back(
        PathSample{ 0.5 * (bead.x_left + bead.x_right), grid.row_y[static_cast<std::size_t>(bead.row)], kRowToeSigma });
  return WeldPath(samples, samples.front().y, samples.back().y, kPathReach);
}

double middleY(const ScanGrid& grid, const BeadTrack& track)
{
  return grid.row_y[static_cast<std::size_t>(track.rows[track.rows.size() / 2].row)];
}

bool liesOnPath(const ScanGrid& grid, const BeadTrack& track, const WeldPath& path, double reach)
{
  const RowBead& bead = track.rows[track.rows.size() / 2];
  const double y = middleY(grid, track);
  const PathPlace place = path.locate(0.5 * (bead.x_left + bead.x_right), y, path.sAt(y));
  return std::abs(place.q) < reach;
}

OtherBead describe(const ScanGrid& grid, const BeadTrack& track)
{
  OtherBead other;
  const RowBead& bead = track.rows[track.rows.size() / 2];
  other.x = 0.5 * (bead.x_left + bead.x_right);
  other.y_from = grid.row_y[static_cast<std::size_t>(track.rows.front().row)];
  other.y_to = grid.row_y[static_cast<std::size_t>(track.rows.back().row)];
  other.width = track.width();
  other.height = track.height();
  return other;
}

std::string whyNone(const ScanGrid& grid, const std::vector<RowFindings>& findings)
{
  if (grid.rows == 0)
    return "the scan holds no measured points";
  if (grid.rows < kFewestRows)
    return "the scan has " + std::to_string(grid.rows) + " rows, a weld is measured from at least " +
           std::to_string(kFewestRows);
  const auto share = [&](bool RowFindings::*what)
  {
    return static_cast<double>(
               std::count_if(findings.begin(), findings.end(), [&](const RowFindings& row) { return row.*what; })) /
           static_cast<double>(findings.size());
  };
  if (share(&RowFindings::straight) < 0.5)
    return "no straight parent surface in view";
  if (share(&RowFindings::sunken) > 0.5)
    return "the surface lies below its surroundings: a groove without weld, or a scan upside down";
  if (share(&RowFindings::block) > 0.5)
    return "what stands on the surface has upright walls: a block or a clamp, not a weld";
  return "no bead rises above the surface";
}

/// Ninth over first tenth of the middle three fifths of a track.
double range(const BeadTrack& track, const std::function<double(const RowBead&)>& size)
{
  const std::size_t count = track.rows.size();
  std::vector<double> values;
  for (std::size_t i = count / 5; i < count - count / 5; ++i)
  {
    std::vector<double> near;  // rows err, shapes do not
    for (std::size_t j = std::max<std::size_t>(i, 3) - 3; j < std::min(count, i + 4); ++j)
      near.push_back(size(track.rows[j]));
    values.push_back(median(std::move(near)));
  }
  std::sort(values.begin(), values.end());
  return values[values.size() - 1 - values.size() / 10] / values[values.size() / 10];
}

/// What is no weld by its shape: its width changes as no weld's middle does, or it is a heap, no longer than wide and
/// highest in its middle. Empty = it may be a weld.
std::string whyNotAWeld(const ScanGrid& grid, const BeadTrack& seen)
{
  BeadTrack track;  // what runs out of view has no width
  std::copy_if(seen.rows.begin(), seen.rows.end(), std::back_inserter(track.rows),
               [](const RowBead& bead) { return bead.whole(); });
  if (track.rows.size() < kFewestToTell || track.height() < kHighEnough)
    return "";
  std::ostringstream text;
  text.precision(3);
  const double widening = range(track, [](const RowBead& bead) { return bead.x_right - bead.x_left; });
  if (widening > kWidening)
    text << "what rises above the surface is no weld: its width changes by a factor of " << widening;
  const int first = track.rows.front().row, last = track.rows.back().row;
  const double length = grid.row_y[static_cast<std::size_t>(last)] - grid.row_y[static_cast<std::size_t>(first)];
  const bool inside = first > 1 && last < grid.rows - 2;
  const double rise = range(track, [](const RowBead& bead) { return bead.height; });
  if (inside && length < kHeapLength * track.width() && rise > kHeapRise)
    text << (text.str().empty() ? "" : "; ") << "what rises above the surface is no weld but a heap: " << 1e3 * length
         << " mm long, " << 1e3 * track.width() << " mm wide, and its height changes by a factor of " << rise;
  return text.str();
}

/// Adds what lies before and behind a track of another, as far as it is about as wide.
void goOn(const BeadTrack& more, BeadTrack& track)
{
  const int first = track.rows.front().row, last = track.rows.back().row;
  const double width = track.width();
  std::copy_if(more.rows.begin(), more.rows.end(), std::back_inserter(track.rows),
               [&](const RowBead& bead)
               {
                 const double ratio = (bead.x_right - bead.x_left) / width;
                 return (bead.row < first || bead.row > last) && ratio > kAsWide && ratio < 1.0 / kAsWide;
               });
  std::sort(track.rows.begin(), track.rows.end(), [](const RowBead& a, const RowBead& b) { return a.row < b.row; });
}

/// Leaves out rows whose bead is far from as wide as in most of the rows around: there it was seen otherwise.
void dropOdd(const ScanGrid& grid, BeadTrack& track)
{
  std::vector<RowBead> kept;
  for (const RowBead& bead : track.rows)
  {
    std::vector<double> widths;
    for (const RowBead& other : track.rows)
    {
      const double apart =
          grid.row_y[static_cast<std::size_t>(other.row)] - grid.row_y[static_cast<std::size_t>(bead.row)];
      if (std::abs(apart) < kAround)
        widths.push_back(other.x_right - other.x_left);
    }
    const double usual = median(std::move(widths));
    if (std::abs(bead.x_right - bead.x_left - usual) <= std::max(kOddShare * usual, kOddWidth))
      kept.push_back(bead);
  }
  track.rows = std::move(kept);
}

/// Takes the rows of tracks that go on along the path into the weld; names the others.
void sortOut(const ScanGrid& grid, std::vector<BeadTrack>& tracks, FoundWeld& found)
{
  const WeldPath path = pathOf(grid, found.track);
  const double width = found.track.width();
  for (std::size_t t = 1; t < tracks.size(); ++t)
  {
    const bool apart = tracks[t].rows.front().row > found.track.rows.back().row ||
                       tracks[t].rows.back().row < found.track.rows.front().row;
    // the same bead, seen otherwise in some rows
    const bool same = !apart && liesOnPath(grid, tracks[t], path, 0.5 * (width + tracks[t].width()));
    if (!same && !(apart && liesOnPath(grid, tracks[t], path, kOnPath * width)))
      found.others.push_back(describe(grid, tracks[t]));
    else
      goOn(tracks[t], found.track);
  }
}
}  // namespace

FoundWeld findWeld(const ScanGrid& grid, const WeldParams& params)
{
  FoundWeld found;
  std::vector<RowFindings> findings;
  if (grid.rows < kFewestRows)
  {
    found.reason = whyNone(grid, findings);
    return found;
  }
  findings.reserve(static_cast<std::size_t>(grid.rows));
  const int step = grid.rows > kEnoughRows ? std::max(1, static_cast<int>(kRowStep / grid.pitch)) : 1;
  for (int row = 0; row < grid.rows; row += step)
    findings.push_back(findRowBeads(grid, row, params));
  std::vector<BeadTrack> tracks = trackBeads(grid, findings, kFewestRows);
  if (tracks.empty())
  {
    found.reason = whyNone(grid, findings);
    return found;
  }
  found.track = tracks.front();
  sortOut(grid, tracks, found);
  found.reason = whyNotAWeld(grid, found.track);
  if (!found.reason.empty())
    return found;
  found.from_y = grid.row_y[static_cast<std::size_t>(found.track.rows.front().row)];
  found.to_y = grid.row_y[static_cast<std::size_t>(found.track.rows.back().row)];
  // a few rows at the scan's ends may have been seen otherwise
  if (found.from_y - grid.row_y.front() < kToTheEnd)
    found.from_y = grid.row_y.front();
  if (grid.row_y.back() - found.to_y < kToTheEnd)
    found.to_y = grid.row_y.back();
  dropOdd(grid, found.track);
  if (found.track.rows.empty())
  {
    found.reason =
        "what rises above the surface is as wide as around it in no row: a parent is not in view, or no weld";
    return found;
  }
  found.path = std::make_shared<WeldPath>(pathOf(grid, found.track));
  return found;
}
}  // namespace weld
}  // namespace weld_profiler
