#pragma once

#include <algorithm>

#include "lanes.h"
#include "stripe_limits.h"
#include "weld_profiler/core/image.h"

namespace weld_profiler
{
// The loops of ColumnCentroid.

struct CentroidLimits
{
  static constexpr float kWindowSigmas = 3.0F;  // half a window; beyond, a Gaussian's square is noise only
  static constexpr float kLeastSigmas = 1.2F;   // of the stripe that must lie inside the image on either side
  static constexpr float kNarrowest = 0.6F;     // [px]
  static constexpr float kAstraySigmas =
      2.0F;                              // from the track's line; a centroid that went farther follows something else
  static constexpr float kWider = 1.3F;  // than the track; a window full of even light has 1.7
  static constexpr int kIterations = 4;
  static constexpr float kSettled = 2e-4F;  // [px]
};

struct CentroidStrip
{
  ImageView image;
  StripeLimits limits;
  int cell;   // first column
  int count;  // columns
  const float *v, *sigma, *background, *gradient, *track_light, *track_weight;
  float *light, *shift, *width, *amplitude, *read_sigma, *brightest;
};

/// Sums over the window of some neighbouring columns.
template <class Lanes>
struct CentroidSums
{
  Lanes weight, moment, second, energy;
  Lanes noise;  // squared derivatives of the moment by each pixel's gray
  Lanes brightest;
};

/// A stretch of the track: line, half width and background of some neighbouring columns, and where the window is.
template <class Lanes>
struct CentroidStretch
{
  Lanes v, sigma, background, gradient, shift, half;
};

template <class Lanes>
WELD_PROFILER_KERNEL float leastOf(const Lanes& lanes)
{
  float result = lanes[0];
  for (int k = 1; k < kLanes<Lanes>; ++k)
    result = std::min(result, lanes[k]);
  return result;
}

template <class Lanes>
WELD_PROFILER_KERNEL void takeRoot(Lanes& lanes)
{
  float values[kLanes<Lanes>];
  store(lanes, values);
  for (float& value : values)
    value = __builtin_sqrtf(value);
  load(values, lanes);
}

template <class Pixel, bool kSquared>
struct MeasureCentroids
{
  template <class Lanes>
  WELD_PROFILER_KERNEL static void run(CentroidStrip strip)
  {
    for (int i = 0; i < strip.count; i += kLanes<Lanes>)
      measure<Lanes>(strip, std::min(i, strip.count - kLanes<Lanes>));
  }

  template <class Lanes>
  WELD_PROFILER_KERNEL static void measure(const CentroidStrip& strip, int first)
  {
    CentroidStretch<Lanes> at;
    load(strip.v + first, at.v);
    load(strip.sigma + first, at.sigma);
    load(strip.background + first, at.background);
    load(strip.gradient + first, at.gradient);
    at.sigma = at.sigma > CentroidLimits::kNarrowest ? at.sigma : Lanes{} + CentroidLimits::kNarrowest;
    at.shift = Lanes{};
    const Lanes farthest = CentroidLimits::kAstraySigmas * at.sigma;
    const float bottom = static_cast<float>(strip.image.height - 1);
    CentroidSums<Lanes> sums;
    for (int i = 0; i < CentroidLimits::kIterations; ++i)
    {
      // The window stays symmetric where the image ends, or the centre would be drawn inward.
      const Lanes above = at.v + at.shift;
      const Lanes below = bottom - above;
      const Lanes room = above < below ? above : below;
      const Lanes whole = CentroidLimits::kWindowSigmas * at.sigma;
      at.half = whole < room ? whole : room;
      sum(strip, first, at, sums);
      const Lanes step = sums.weight > 0.0F ? sums.moment / sums.weight : Lanes{};
      const Lanes there = at.shift + step;
      // One that left the stripe goes no farther: a pixel beyond the limit that write() asks for.
      const Lanes low = there > -1.0F - farthest ? there : -1.0F - farthest;
      at.shift = low < 1.0F + farthest ? low : 1.0F + farthest;
      if (leastOf(step) > -CentroidLimits::kSettled && leastOf(Lanes(-step)) > -CentroidLimits::kSettled)
        break;
    }
    tell(strip, first, at, sums);
  }

  template <class Lanes>
  WELD_PROFILER_KERNEL static void sum(const CentroidStrip& strip, int first, const CentroidStretch<Lanes>& at,
                                       CentroidSums<Lanes>& sums)
  {
    const Lanes reach = at.half + 0.5F;
    const Lanes middle = at.v + at.shift;
    const int begin = std::max(0, static_cast<int>(leastOf(Lanes(middle - reach))));
    const int end = std::min(strip.image.height - 1, static_cast<int>(-leastOf(Lanes(-middle - reach))) + 1);
    sums = CentroidSums<Lanes>{};
    for (int row = begin; row <= end; ++row)
    {
      const Lanes off = static_cast<float>(row) - at.v;
      const Lanes y = off - at.shift;
      const Lanes left = reach - (y > 0.0F ? y : -y);
      const Lanes some = left > 0.0F ? left : Lanes{};
      const Lanes inside = some < 1.0F ? some : Lanes{} + 1.0F;
      Lanes pixel;
      loadPixels(strip.image.row<Pixel>(row) + strip.cell + first, pixel);
      const Lanes gray = pixel - at.background - at.gradient * off;
      const Lanes light = inside * gray;
      const Lanes energy = light * gray;
      const Lanes weight = kSquared ? energy : light;
      const Lanes moment = weight * y;
      const Lanes change = (kSquared ? 2.0F * light : inside) * y;
      const Lanes seen = left > 0.0F ? pixel : Lanes{};
      sums.weight += weight;
      sums.moment += moment;
      sums.second += moment * y;
      sums.energy += energy;
      sums.noise += change * change;
      sums.brightest = seen > sums.brightest ? seen : sums.brightest;
    }
  }

  template <class Lanes>
  WELD_PROFILER_KERNEL static void tell(const CentroidStrip& strip, int first, const CentroidStretch<Lanes>& at,
                                        const CentroidSums<Lanes>& sums)
  {
    constexpr float kSqrtPi = 1.7724539F;
    constexpr int kSide = 4;  // columns that the slope is told from, either side
    Lanes light, measured;
    load(strip.track_light + first, light);
    load(strip.track_weight + first, measured);
    const Lanes far = CentroidLimits::kAstraySigmas * at.sigma;
    const auto stayed = (at.shift <= far) & (at.shift >= -far) & (at.half >= CentroidLimits::kLeastSigmas * at.sigma);
    const auto there = (measured > 0.0F) & (sums.weight > 0.0F) & (sums.second > 0.0F);
    const auto bright = (light >= strip.limits.least_light) & (light * light * at.sigma >= strip.limits.leastSquare());
    // A squared Gaussian is narrower by sqrt(2).
    Lanes width = (kSquared ? 2.0F : 1.0F) * sums.second / sums.weight;
    takeRoot(width);
    Lanes height = sums.energy / (width * kSqrtPi);
    takeRoot(height);
    Lanes noise = sums.noise;
    takeRoot(noise);
    const Lanes room = strip.limits.saturation - at.background - at.gradient * at.shift;
    const Lanes low = height < room ? height : room;
    Lanes before, after;
    load(strip.v + first - kSide, before);
    load(strip.v + first + kSide, after);
    const Lanes rise = (after - before) * (0.5F / kSide);
    const Lanes square = width * width / (1.0F + rise * rise);  // across the stripe
    const float narrowest = strip.limits.least_width * strip.limits.least_width;
    const auto fits = (width <= CentroidLimits::kWider * at.sigma) & (low >= strip.limits.least_light) &
                      (square >= narrowest) & (square <= strip.limits.most_width * strip.limits.most_width);
    light = (stayed & there & bright & fits) ? light : Lanes{};
    store(light, strip.light + first);
    store(at.shift, strip.shift + first);
    store(width, strip.width + first);
    store(low, strip.amplitude + first);
    store(Lanes(strip.limits.noise * noise / sums.weight), strip.read_sigma + first);
    store(sums.brightest, strip.brightest + first);
  }
};
}  // namespace weld_profiler
