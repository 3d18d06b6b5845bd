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
constexpr int kMove = 24;             // rows that a stripe may move from frame to frame and still be followed
constexpr double kMostOfFrame = 0.6;  // share of the rows; a higher band is not worth it
constexpr float kRiseOutside = 1.8F;  // of what a peak needs, over the darkest: ten sigmas
constexpr double kWhole = 0.95;       // of the last stripe's cells that must be found
}  // namespace

/// From differences of sums that lie two samples apart in a few even rows, which are summed always: most of a frame is
/// background.
void StripeFinder::measureNoise()
{
  std::array<int, kNoiseBins> histogram{};
  int total = 0;
  const int stride = 2 * std::max(1, sums_.rows() / (2 * kNoiseRows));
  const int shift = 2;
  for (int i = 0; i + 2 < sums_.rows(); i += stride)
  {
    const std::uint16_t* a = sums_.row(i);
    const std::uint16_t* b = sums_.row(i + 2);
    for (int k = 0; k < sums_.groups(); k += shift)
    {
      ++histogram[static_cast<std::size_t>(std::min(kNoiseBins - 1, std::abs(a[k] - b[k])))];
      ++total;
    }
  }
  int below = 0;
  int bin = 0;
  while (bin + 1 < kNoiseBins && 2 * (below + histogram[static_cast<std::size_t>(bin)]) < total)
    below += histogram[static_cast<std::size_t>(bin++)];
  const int here = std::max(1, histogram[static_cast<std::size_t>(bin)]);
  const float median = static_cast<float>(bin) - 0.5F +
                       (0.5F * static_cast<float>(total) - static_cast<float>(below)) / static_cast<float>(here);
  // Noise of one pixel: a sum of 8 has sqrt(8) of it.
  noise_ = std::max(0.0F, median) / kMedianOfDifference * std::sqrt(static_cast<float>(kGroup)) / sums_.perLevel();
  noise_ = std::max(noise_, kQuantisation);
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
  const auto [lowest, highest] = std::minmax_element(last.v.begin(), last.v.end());
  constexpr int kRoom = GroupPeaks::kReach + kMove;
  sums_.layOut(image, row_step);
  RowRange band;
  band.first = std::max(0, (static_cast<int>(*lowest) - kRoom) / row_step);
  band.last = std::min(sums_.rows(), (static_cast<int>(*highest) + kRoom) / row_step + 1);
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
