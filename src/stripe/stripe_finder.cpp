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
}  // namespace

/// From differences of sums that lie two samples apart in a few rows: most of a frame is background.
void StripeFinder::measureNoise()
{
  std::array<int, kNoiseBins> histogram{};
  int total = 0;
  const int stride = std::max(1, sums_.rows() / kNoiseRows);
  const int shift = 2;
  for (int i = 0; i + 1 < sums_.rows(); i += stride)
  {
    const std::uint16_t* a = sums_.row(i);
    const std::uint16_t* b = sums_.row(i + 1);
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

void StripeFinder::look(const ImageView& image, int row_step, float least_peak)
{
  sums_.measure(image, row_step);
  measureNoise();
  const float noise = noise_ / std::sqrt(static_cast<float>(kGroup));
  peaks_.find(sums_, std::max(kHeightOverPeak * least_peak, kHeightOverNoise * noise) * sums_.perLevel());
  path_.choose(sums_, peaks_, nodes_);
  dropLoners(nodes_);
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

void StripeFinder::find(const ImageView& image, const Levels& levels, double min_peak_counts, ColumnTrack& track)
{
  const auto least = static_cast<float>(min_peak_counts * levels.count);
  const int step = std::clamp(image.height / kRowsKept, 1, kMostRowStep);
  look(image, step, least);
  if (step > 1 && static_cast<double>(nodes_.size()) < kEnoughGroups * sums_.groups())
    look(image, 1, least);
  if (!standsOut())
    nodes_.clear();
  laid_.lay(sums_, nodes_, noise_, track);
}
}  // namespace weld_profiler
