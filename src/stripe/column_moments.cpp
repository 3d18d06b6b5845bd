#include "column_moments.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include "multiversion.h"
#include "pixels.h"

namespace weld_profiler
{
namespace
{
constexpr int kLanes = 8;
typedef float Lanes __attribute__((vector_size(kLanes * sizeof(float))));
typedef std::int32_t WholeLanes __attribute__((vector_size(kLanes * sizeof(std::int32_t))));

// Integrals over z of t^6 g, of z^2 t^6 g and of z flank(z) g over it, g the Gaussian profile.
constexpr float kLightPerHeight = 1.8719F;
constexpr float kCoreGain = 0.54376F;
constexpr float kFlankGain = 0.011007F;
constexpr int kAhead = 96;       // columns: the window is high and narrow, the processor does not see where it goes
constexpr float kWindow = 3.4F;  // half widths; beyond, the weights are nothing
constexpr float kLeastRows = 2.0F;
constexpr float kLightOverNoise = 4.0F;
constexpr float kTorn = 0.9F;        // half widths that flanks and core may differ by, and
constexpr float kSampled = 1.2F;     // [px] narrower stripes have too few pixels for flanks
constexpr float kTornNoise = 20.0F;  // sigmas of what pixel noise alone makes of it
constexpr float kInside = 2.5F;      // half widths of the stripe that must lie inside the image on either side
constexpr float kFarthest = 1.5F;    // half widths that a centre may lie off the reference line

struct Strip
{
  ImageView image;
  int cell;   // first column
  int count;  // columns
  const float *v, *sigma, *background, *gradient;
  float noise;  // 1-sigma of one pixel
  float *light, *core, *flanks, *spread, *peak, *weight;
};

template <class Pixel>
WELD_PROFILER_KERNEL void load(const Pixel* pixels, Lanes& lanes)
{
  typedef Pixel Raw __attribute__((vector_size(kLanes * sizeof(Pixel))));
  Raw raw;
  __builtin_memcpy(&raw, pixels, sizeof(raw));
  lanes = __builtin_convertvector(__builtin_convertvector(raw, WholeLanes), Lanes);
}

#if defined(__SSE2__)
/// What gcc 12 makes of the conversion above goes byte by byte.
WELD_PROFILER_KERNEL void load(const std::uint8_t* pixels, Lanes& lanes)
{
  const __m128i zero = _mm_setzero_si128();
  const __m128i words = _mm_unpacklo_epi8(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(pixels)), zero);
  typedef std::uint16_t Words __attribute__((vector_size(kLanes * sizeof(std::uint16_t))));
  lanes = __builtin_convertvector(__builtin_convertvector(reinterpret_cast<Words>(words), WholeLanes), Lanes);
}
#endif

WELD_PROFILER_KERNEL void load(const float* from, Lanes& lanes)
{
  __builtin_memcpy(&lanes, from, sizeof(lanes));
}

WELD_PROFILER_KERNEL void storeLanes(const Lanes& lanes, float* to)
{
  __builtin_memcpy(to, &lanes, sizeof(lanes));
}

struct Sums
{
  Lanes light{}, core{}, flanks{}, spread{}, peak{};
};

/// @tparam kWhole  false: light, core and spread alone, all that is wanted to settle the reference line.
template <class Pixel, bool kWhole>
struct MeasureColumns
{
  WELD_PROFILER_KERNEL static void run(Strip strip)
  {
    for (int i = 0; i < strip.count; i += kLanes)
      measureLanes(strip, std::min(i, strip.count - kLanes));
  }

  WELD_PROFILER_KERNEL static void measureLanes(const Strip& strip, int first)
  {
    Lanes v;
    load(strip.v + first, v);
    Lanes sigma;
    load(strip.sigma + first, sigma);
    Lanes background;
    load(strip.background + first, background);
    Lanes gradient;
    load(strip.gradient + first, gradient);
    const Lanes scale = 1.0F / sigma;
    float low = 1e9F;
    float high = -1e9F;
    for (int k = 0; k < kLanes; ++k)
    {
      const float reach = std::max(kWindow * strip.sigma[first + k], kLeastRows);
      low = std::min(low, strip.v[first + k] - reach);
      high = std::max(high, strip.v[first + k] + reach);
    }
    const int begin = std::max(0, static_cast<int>(low));
    const int end = std::min(strip.image.height - 1, static_cast<int>(high) + 1);
    Sums sums;
    const Pixel* pixels = strip.image.row<Pixel>(begin) + strip.cell + first;
    const std::size_t stride = strip.image.step / sizeof(Pixel);
    const Lanes above = static_cast<float>(begin) - v;
    Lanes z = above * scale;
    Lanes dark = background + gradient * above;
    for (int row = begin; row <= end; ++row, pixels += stride, z += scale, dark += gradient)
    {
      __builtin_prefetch(pixels + kAhead);
      const Lanes square = z * z;
      Lanes t = 1.0F - 0.0625F * square;
      t = t > 0.0F ? t : Lanes{};
      Lanes gray;
      load(pixels, gray);
      const Lanes light = gray - dark;
      const Lanes t2 = t * t;
      const Lanes t3 = t2 * t;
      const Lanes weighted = t3 * t3 * light;
      const Lanes moment = z * weighted;
      sums.light += weighted;
      sums.core += moment;
      sums.spread += z * moment;
      if (!kWhole)
        continue;
      const Lanes off = 1.0F - t;
      sums.flanks += off * off * (t2 * t3) * (z * light);
      const Lanes top = square < 1.0F ? gray : Lanes{};
      sums.peak = top > sums.peak ? top : sums.peak;
    }
    store(strip, first, sums, sigma, scale);
  }

  WELD_PROFILER_KERNEL static void store(const Strip& strip, int first, const Sums& sums, const Lanes& sigma,
                                         const Lanes& scale)
  {
    const Lanes inverse = 1.0F / (sums.light > 1e-6F ? sums.light : Lanes{} + 1e-6F);
    const Lanes core = sigma * sums.core * inverse * (1.0F / kCoreGain);
    const Lanes shift = sums.core * inverse;
    const Lanes variance = sums.spread * inverse - shift * shift;
    // For Gaussians: 1 / variance = 1 / spread^2 + 1 / w^2, with 1 / w^2 = 1 / gain - 1.
    constexpr float kInverseSquare = 1.0F / kCoreGain - 1.0F;
    const Lanes rest = 1.0F - kInverseSquare * variance;
    const Lanes square = variance / (rest > 0.05F ? rest : Lanes{} + 0.05F);
    storeLanes(sums.light * scale * (1.0F / kLightPerHeight), strip.light + first);
    storeLanes(core, strip.core + first);
    const Lanes flanks = sigma * sums.flanks * inverse * (1.0F / kFlankGain);
    storeLanes(flanks, strip.flanks + first);
    storeLanes(square, strip.spread + first);
    storeLanes(sums.peak, strip.peak + first);
    const Lanes one = Lanes{} + 1.0F;
    const Lanes far = kFarthest * sigma;
    Lanes v;
    load(strip.v + first, v);
    const Lanes centre = v + core;
    const Lanes bottom = Lanes{} + static_cast<float>(strip.image.height) - 0.5F - kInside * sigma;
    // Spatter beside the stripe pulls the flanks away from the core.
    const Lanes torn = kWhole ? flanks - core : Lanes{};
    const Lanes noise = strip.noise * sigma * sigma / (sums.light > 1e-6F ? sums.light : Lanes{} + 1e-6F);
    const Lanes wide = sigma > kSampled ? sigma : Lanes{} + kSampled;
    const Lanes most = kTorn * wide + kTornNoise * noise * scale;
    const Lanes fits = (torn < most && torn > -most && sums.light > 1e-6F && core < far && core > -far &&
                        square > 0.0F && centre > kInside * sigma - 0.5F && centre < bottom)
                           ? one
                           : Lanes{};
    // A column without light must not be averaged into those beside it.
    const Lanes height = sums.light * scale * (1.0F / kLightPerHeight);
    const float faint = kLightOverNoise * strip.noise;
    storeLanes(height * height * sigma >= faint * faint ? fits : Lanes{}, strip.weight + first);
  }
};
}  // namespace

template <bool kWhole>
void ColumnMoments::run(const ImageView& image, float noise, ColumnTrack& track)
{
  std::fill(track.weight.begin(), track.weight.end(), 0.0F);
  for (const ColumnTrack::Piece& piece : track.pieces)
  {
    const auto slot = static_cast<std::size_t>(piece.slot);
    const Strip strip{ image,
                       piece.cell,
                       piece.count,
                       &track.v[slot],
                       &track.sigma[slot],
                       &track.background[slot],
                       &track.gradient[slot],
                       noise,
                       &track.light[slot],
                       &track.core[slot],
                       &track.flanks[slot],
                       &track.spread[slot],
                       &track.peak[slot],
                       &track.weight[slot] };
    withPixel(image, [&](auto pixel) { dispatch<MeasureColumns<decltype(pixel), kWhole>>(strip); });
  }
}

void ColumnMoments::locate(const ImageView& image, float noise, ColumnTrack& track)
{
  run<false>(image, noise, track);
}

void ColumnMoments::measure(const ImageView& image, float noise, ColumnTrack& track)
{
  track.noise = noise;
  run<true>(image, noise, track);
}
}  // namespace weld_profiler
