#include "frame_statistics.h"

#include <cmath>

#include "otsu.h"

namespace weld_profiler
{
namespace
{
constexpr int kColumns = 96;                    ///< that give the histogram: 0.1 ms instead of 1 ms a frame
constexpr int kNoiseRows = 32;                  ///< rows that give the noise
constexpr double kQuantisation = 0.29;          ///< 1-sigma of rounding to whole levels of 8 bit: 1 / sqrt(12)
constexpr float kToNearest = 0.5F;              ///< rounds where std::lround() would double the time
constexpr double kMedianOfDifference = 0.9539;  ///< median of |a - b| of two normal values, in their sigma

/// Value below which a share of the histogram lies. Bin i holds values from i - 1/2 to i + 1/2, bin 0 those from 0.
double quantile(const Histogram& histogram, double share)
{
  double left = 0.0;
  for (const std::uint32_t count : histogram)
    left += share * count;
  for (int i = 0; i < kBins; ++i)
  {
    if (histogram[i] > 0 && left <= histogram[i])
    {
      const double low = std::max(0.0, i - 0.5);
      return low + (i + 0.5 - low) * left / histogram[i];
    }
    left -= histogram[i];
  }
  return kBins - 0.5;
}

template <class Pixel>
void sampleLevels(const ImageView& image, double bin, Histogram& histogram)
{
  const int stride = std::max(1, image.width / kColumns);
  const auto scale = static_cast<float>(1.0 / bin);
  const bool whole = sizeof(Pixel) == 1 && bin == 1.0;
  std::array<Histogram, 2> part{};  // two, so that equal neighbours don't wait for each other's store
  for (int v = 0; v < image.height; ++v)
  {
    const Pixel* row = image.row<Pixel>(v);
    int which = 0;
    for (int u = stride / 2; u < image.width; u += stride, which ^= 1)
    {
      const int level = whole ? row[u] : static_cast<int>(static_cast<float>(row[u]) * scale);
      ++part[which][std::min(level, kBins - 1)];
    }
  }
  for (int i = 0; i < kBins; ++i)
    histogram[i] = part[0][i] + part[1][i];
}

/// From the differences of neighbours along the rows, where a stripe along the rows hardly changes.
template <class Pixel>
double noiseAlongRows(const ImageView& image, double bin)
{
  Histogram differences{};
  const int stride = std::max(1, image.height / kNoiseRows);
  const auto scale = static_cast<float>(1.0 / bin);
  for (int v = stride / 2; v < image.height; v += stride)
  {
    const Pixel* row = image.row<Pixel>(v);
    for (int u = 1; u < image.width; ++u)
    {
      const auto difference = static_cast<float>(std::abs(static_cast<int>(row[u]) - static_cast<int>(row[u - 1])));
      ++differences[std::min(static_cast<int>(difference * scale + kToNearest), kBins - 1)];
    }
  }
  return bin * std::max(quantile(differences, 0.5) / kMedianOfDifference, kQuantisation);
}
}  // namespace

void measureFrame(const ImageView& image, const Levels& levels, FrameStatistics& statistics)
{
  const double bin = levels.bin();
  double noise = 0.0;
  withPixel(image,
            [&](auto pixel)
            {
              using Pixel = decltype(pixel);
              sampleLevels<Pixel>(image, bin, statistics.histogram);
              noise = noiseAlongRows<Pixel>(image, bin);
            });
  // A tenth of the pixels lies below: background even where stripe and glow fill most of a narrow region.
  constexpr double kShare = 0.1;
  constexpr double kBelowMean = 1.28;  // sigmas from a normal distribution's 10 % to its middle
  statistics.background = bin * quantile(statistics.histogram, kShare) + kBelowMean * noise;
  statistics.otsu = bin * (otsuBin(statistics.histogram) + 1);

  double total = 0.0;
  for (const std::uint32_t count : statistics.histogram)
    total += count;
  statistics.saturated_share = statistics.histogram[kBins - 1] / total;
}
}  // namespace weld_profiler
