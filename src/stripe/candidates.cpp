#include "candidates.h"

#include <limits>

namespace weld_profiler
{
namespace
{
constexpr int kRows = TiledMedian::kTileRows;
constexpr int kChunk = 32;                     ///< columns looked at together when skipping the dark ones
constexpr double kFloorSigmas = 3.5;           ///< of raw noise: one dark pixel in 4000 is looked at in vain
constexpr double kContrastSigmas = 5.0;        ///< of filtered noise
constexpr double kFullWidthPerSigma = 2.3548;  ///< of a Gaussian at half height
constexpr double kSteepest = 2.5;              ///< widening down the column of a stripe at 66 deg

/// What is left of white noise after the median filter.
double medianGain(int size)
{
  return size == 0 ? 1.0 : (size == 3 ? 0.42 : 0.25);
}

template <class Pixel>
void raiseTo(const Pixel* values, int count, Pixel* __restrict highest)
{
  for (int i = 0; i < count; ++i)
    highest[i] = std::max(highest[i], values[i]);
}

template <class Pixel>
Pixel largest(const Pixel* values, int count)
{
  Pixel result = 0;
  for (int i = 0; i < count; ++i)
    result = std::max(result, values[i]);
  return result;
}
}  // namespace

template <>
std::vector<std::uint8_t>& CandidateFinder::maxima()
{
  return maxima8_;
}

template <>
std::vector<std::uint16_t>& CandidateFinder::maxima()
{
  return maxima16_;
}

void CandidateFinder::find(const ImageView& image, const StripeParams& params, const FrameStatistics& statistics,
                           CandidateList& candidates)
{
  const Levels levels = levelsOf(image, params);
  // Half the height: smoothing lowers the top of a narrow stripe. The full height is asked for once it is measured.
  const double half_height = 0.5 * params.min_peak_counts * levels.count;
  const double noise = statistics.noise * medianGain(params.median_size_px);
  least_contrast_ = static_cast<float>(std::max(half_height, kContrastSigmas * noise));
  const double floor = statistics.background + std::max(half_height, kFloorSigmas * statistics.noise);

  median_.reset(image, params.median_size_px);
  zone_count_.assign(static_cast<std::size_t>(image.width), 0);
  zones_.resize(static_cast<std::size_t>(image.width) * kZones);
  withPixel(image, [&](auto pixel) { findZones<decltype(pixel)>(image, floor); });
  requestTiles(image.width, (image.height + kRows - 1) / kRows);
  median_.filter();

  candidates.items.clear();
  candidates.first.assign(1, 0);
  candidates.total_brightness.clear();
  for (int u = 0; u < image.width; ++u)
  {
    found_.clear();
    for (int i = 0; i < zone_count_[static_cast<std::size_t>(u)]; ++i)
    {
      const Zone zone = zones_[static_cast<std::size_t>(u) * kZones + static_cast<std::size_t>(i)];
      const int first_row = std::max(0, (zone.first_block - 1) * kRows);
      const int last_row = std::min(image.height - 1, (zone.last_block + 2) * kRows - 1);
      withPixel(image, [&](auto pixel) { readProfile<decltype(pixel)>(u, first_row, last_row); });
      peaks_.find(profile_, least_contrast_);
      for (const ColumnPeak& peak : peaks_.found())
        addCandidate(peak, first_row, kSteepest * params.max_stripe_width_px + 1.0);
    }
    keepBrightest(candidates);
  }
}

template <class Pixel>
void CandidateFinder::findZones(const ImageView& image, double floor)
{
  const int width = image.width;  // a copy: the compiler must know that writing pixels does not change it
  const auto dark = static_cast<Pixel>(std::min<double>(floor, std::numeric_limits<Pixel>::max()));
  std::vector<Pixel>& highest = maxima<Pixel>();
  highest.resize(static_cast<std::size_t>(width));
  for (int block = 0; block * kRows < image.height; ++block)
  {
    const int first = block * kRows;
    std::copy_n(image.row<Pixel>(first), width, highest.begin());
    for (int v = first + 1; v < std::min(image.height, first + kRows); ++v)
      raiseTo(image.row<Pixel>(v), width, highest.data());
    for (int begin = 0; begin < width; begin += kChunk)
    {
      const int end = std::min(width, begin + kChunk);
      if (largest(highest.data() + begin, end - begin) <= dark)
        continue;
      for (int u = begin; u < end; ++u)
        if (highest[static_cast<std::size_t>(u)] > dark)
          addBlock(u, block);
    }
  }
}

void CandidateFinder::addBlock(int u, int block)
{
  std::uint8_t& count = zone_count_[static_cast<std::size_t>(u)];
  Zone* zones = zones_.data() + static_cast<std::ptrdiff_t>(u) * kZones;
  const auto row = static_cast<std::int16_t>(block);
  // Zones a block apart share the rows between them, so they are one.
  if (count > 0 && zones[count - 1].last_block + 2 >= row)
    zones[count - 1].last_block = row;
  else if (count < kZones)
    zones[count++] = Zone{ row, row };
}

void CandidateFinder::requestTiles(int width, int blocks)
{
  for (int u = 0; u < width; ++u)
    for (int i = 0; i < zone_count_[static_cast<std::size_t>(u)]; ++i)
    {
      const Zone zone = zones_[static_cast<std::size_t>(u) * kZones + static_cast<std::size_t>(i)];
      for (int block = std::max(0, zone.first_block - 1); block <= std::min(blocks - 1, zone.last_block + 1); ++block)
        median_.request(u, block);
    }
}

/// One column of the filtered image, each value the mean of three rows.
template <class Pixel>
void CandidateFinder::readProfile(int u, int first_row, int last_row)
{
  const ImageView& image = median_.filtered();
  const auto at = [&](int v) { return static_cast<float>(image.row<Pixel>(v)[u]); };
  profile_.resize(static_cast<std::size_t>(last_row - first_row) + 1);
  float before = at(first_row);
  float here = before;
  for (int v = first_row; v <= last_row; ++v)
  {
    const float after = v < last_row ? at(v + 1) : here;
    profile_[static_cast<std::size_t>(v - first_row)] = (before + here + after) / 3.0F;
    before = here;
    here = after;
  }
}

void CandidateFinder::addCandidate(const ColumnPeak& peak, int first_row, double widest)
{
  const float* p = profile_.data();
  const float base = std::max(p[peak.left_foot], p[peak.right_foot]);
  const float height = p[peak.top] - base;
  if (height < least_contrast_)
    return;
  const float level = base + 0.5F * height;
  int first = peak.left_foot;
  int last = peak.right_foot;
  while (first < peak.top && p[first] <= level)
    ++first;
  while (last > peak.top && p[last] <= level)
    --last;
  float weight = 0.0F;
  float moment = 0.0F;
  for (int i = first; i <= last; ++i)
  {
    const float above = std::max(0.0F, p[i] - level);
    weight += above;
    moment += above * static_cast<float>(i);
  }
  const double sigma = (last - first + 1) / kFullWidthPerSigma;
  if (sigma > widest || !(weight > 0.0F))
    return;
  Candidate candidate;
  candidate.v = static_cast<float>(first_row) + moment / weight;
  candidate.sigma = static_cast<float>(sigma);
  candidate.height = height;
  candidate.top = p[peak.top];
  candidate.brightness = height * static_cast<float>(sigma);
  found_.push_back(candidate);
}

void CandidateFinder::keepBrightest(CandidateList& candidates)
{
  float total = 0.0F;
  for (const Candidate& candidate : found_)
    total += candidate.brightness;
  candidates.total_brightness.push_back(total);
  if (found_.size() > static_cast<std::size_t>(kPerColumn))
  {
    const auto brighter = [](const Candidate& a, const Candidate& b) { return a.brightness > b.brightness; };
    std::partial_sort(found_.begin(), found_.begin() + kPerColumn, found_.end(), brighter);
    found_.resize(kPerColumn);
    std::sort(found_.begin(), found_.end(), [](const Candidate& a, const Candidate& b) { return a.v < b.v; });
  }
  candidates.items.insert(candidates.items.end(), found_.begin(), found_.end());
  candidates.first.push_back(static_cast<int>(candidates.items.size()));
}
}  // namespace weld_profiler
