#include "stripe_finder.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace weld_profiler
{
namespace
{
constexpr int kRowsKept = 128;         // a frame is never thinned below as many rows
constexpr int kMostRowStep = 4;        // half widths from 1.2 px on are met
constexpr double kEnoughGroups = 0.6;  // share of the groups that a thinned frame must show
constexpr int kNoiseRows = 16;
constexpr int kNoiseBins = 256;
constexpr float kMedianOfDifference = 0.9539F;  // median of |a - b| of two normal values, in their sigma
constexpr float kQuantisation = 0.29F;          // [grey levels] 1 / sqrt(12)
constexpr float kHeightOverNoise = 6.0F;
constexpr float kHeightOverPeak = 0.35F;  // an oblique stripe fills a part of a group's row
constexpr float kLeastShare = 0.25F;      // of all peaks of its groups; less is a pattern, no stripe
constexpr int kMove = 24;                 // rows that a stripe may move from frame to frame and still be followed
constexpr double kMostOfFrame = 0.6;      // share of the rows; a higher band is not worth it
constexpr float kRiseOutside = 1.25F;     // of what a peak needs, over the darkest
constexpr double kWhole = 0.95;           // of the last stripe's cells that must be found
}  // namespace

/// From differences of sums that lie two samples apart in a few even rows, which are summed always, down the columns or
/// along the rows: most of a frame is background, and where a narrow region holds more of the stripe, one of the two
/// runs along it.
void StripeFinder::measureNoise()
{
  const float difference = std::min(medianDifference(2, 0), medianDifference(0, 1));
  // Noise of one pixel: a sum of 8 has sqrt(8) of it.
  noise_ = difference / kMedianOfDifference * std::sqrt(static_cast<float>(kGroup)) / sums_.perLevel();
  noise_ = std::max(noise_, kQuantisation);
}

/// Median of the differences between sums that are some rows and groups apart, from a histogram; where that is too
/// short, as it is for 16 bit, from a coarser one.
float StripeFinder::medianDifference(int rows, int groups) const
{
  constexpr int kCoarser = 5;  // for 16 bit, bins of an eighth of a level of 8 bit, as they are for 8 bit
  constexpr int kMostShift = 10;
  for (int shift = 0;; shift += kCoarser)
  {
    const int half = (1 << shift) / 2;
    std::array<int, kNoiseBins> histogram{};
    int total = 0;
    const int stride = 2 * std::max(1, sums_.rows() / (2 * kNoiseRows));
    for (int i = 0; i + rows < sums_.rows(); i += stride)
    {
      const std::uint16_t* a = sums_.row(i);
      const std::uint16_t* b = sums_.row(i + rows) + groups;
      for (int k = 0; k + groups < sums_.groups(); k += 4)
      {
        ++histogram[static_cast<std::size_t>(std::min(kNoiseBins - 1, (std::abs(a[k] - b[k]) + half) >> shift))];
        ++total;
      }
    }
    int below = 0;
    int bin = 0;
    while (bin + 1 < kNoiseBins && 2 * (below + histogram[static_cast<std::size_t>(bin)]) < total)
      below += histogram[static_cast<std::size_t>(bin++)];
    if (bin + 1 == kNoiseBins && shift < kMostShift)
      continue;
    const int here = std::max(1, histogram[static_cast<std::size_t>(bin)]);
    const float share = (0.5F * static_cast<float>(total) - static_cast<float>(below)) / static_cast<float>(here);
    return std::max(0.0F, static_cast<float>(1 << shift) * (static_cast<float>(bin) + share - 0.5F));
  }
}

float StripeFinder::leastHeight(float least_peak) const
{
  const float noise = noise_ / std::sqrt(static_cast<float>(kGroup));
  return std::max(kHeightOverPeak * least_peak, kHeightOverNoise * noise) * sums_.perLevel();
}

void StripeFinder::choose(float least_peak, const RowRange& rows)
{
  peaks_.find(sums_, leastHeight(least_peak), rows);
  path_.choose(sums_, peaks_, nodes_);
  dropLoners(nodes_);
}

void StripeFinder::look(const ImageView& image, int row_step, float least_peak)
{
  sums_.layOut(image, row_step);
  sums_.sum(image, 0, sums_.rows());
  measureNoise();
  choose(least_peak, RowRange{ 0, sums_.rows() });
}

/// @return whether everything else may be left out.
bool StripeFinder::follow(const ImageView& image, int row_step, float least_peak, const Stripe& last)
{
  float lowest = last.v.back();
  float highest = last.v.back();
  for (std::size_t i = 0; i < last.v.size(); i += kGroup / 2)
  {
    lowest = std::min(lowest, last.v[i]);
    highest = std::max(highest, last.v[i]);
  }
  constexpr int kRoom = GroupPeaks::kReach + kMove;
  sums_.layOut(image, row_step);
  RowRange band;
  band.first = std::max(0, (static_cast<int>(lowest) - kRoom) / row_step);
  band.last = std::min(sums_.rows(), (static_cast<int>(highest) + kRoom) / row_step + 1);
  if (band.last - band.first > kMostOfFrame * sums_.rows() || band.first >= band.last)
    return false;
  sums_.sum(image, band.first, band.last);
  sums_.sum(image, 0, band.first, 2);
  sums_.sum(image, band.last + band.last % 2, sums_.rows(), 2);
  measureNoise();
  if (GroupPeaks::risesOutside(sums_, kRiseOutside * leastHeight(least_peak), band))
    return false;
  choose(least_peak, band);
  if (static_cast<double>(kGroup * nodes_.size()) < kWhole * static_cast<double>(last.v.size()))
    return false;
  const int reach = GroupPeaks::kReach / row_step;
  return std::all_of(nodes_.begin(), nodes_.end(),
                     [&](const PathNode& node)
                     {
                       return (band.first == 0 || node.peak.row - band.first > reach) &&
                              (band.last == sums_.rows() || band.last - node.peak.row > reach);
                     });
}

/// The line's share of what is bright in its groups: a stripe stands out, a row of a checkerboard does not.
bool StripeFinder::standsOut() const
{
  float own = 0.0F;
  float all = 0.0F;
  for (const PathNode& node : nodes_)
  {
    own += node.peak.height;
    for (int i = 0; i < peaks_.size(node.group); ++i)
      all += peaks_.at(node.group, i).height;
  }
  return own >= kLeastShare * all;
}

void StripeFinder::find(const ImageView& image, float least_peak, const Stripe* last, ColumnTrack& track)
{
  const int step = std::clamp(image.height / kRowsKept, 1, kMostRowStep);
  const auto sparse = [&] { return static_cast<double>(nodes_.size()) < kEnoughGroups * sums_.groups(); };
  const bool known = last != nullptr && !last->v.empty();
  if (!known || !follow(image, step, least_peak, *last) || sparse())
  {
    look(image, step, least_peak);
    if (step > 1 && sparse())
      look(image, 1, least_peak);
  }
  if (!standsOut())
    nodes_.clear();
  laid_.lay(sums_, nodes_, noise_, track);
}
}  // namespace weld_profiler
