#include "ridge_centres.h"

#include <algorithm>
#include <cmath>

#include "multiversion.h"
#include "steep_links.h"

namespace weld_profiler
{
namespace
{
constexpr std::size_t kBesideUpright = 3;  // centres
constexpr float kUnsure = 0.25F;           // half widths; a centre that may be off by more is none
constexpr float kSampled = 2.0F;           // [px] a narrower stripe is not told better for it
constexpr float kHalfPi = 1.57079625F;     // the largest float that is not beyond

/// To 1e-5 rad: M. Abramowitz, I. Stegun, Handbook of Mathematical Functions, 4.4.49, and atan(x) + atan(1 / x) = pi/2.
WELD_PROFILER_KERNEL float arcTangent(float x)
{
  const float size = __builtin_fabsf(x);
  const float inverse = 1.0F / (size > 1.0F ? size : 1.0F);
  const float argument = size > 1.0F ? inverse : size;
  const float square = argument * argument;
  const float angle =
      argument *
      (0.999866F + square * (-0.3302995F + square * (0.180141F + square * (-0.085133F + square * 0.0208351F))));
  const float rest = kHalfPi - angle;
  const float whole = size > 1.0F ? rest : angle;
  return __builtin_copysignf(whole, x);
}

struct Finish
{
  struct In
  {
    int count;
    StripeLimits limits;
    const float *slope, *row_sigma, *columns, *light, *column_width, *background, *peak, *ambiguous;
    float *good, *angle, *intensity, *width, *sigma;
    std::uint8_t* flags;
  };
  WELD_PROFILER_KERNEL static void run(In in)
  {
    const StripeLimits limits = in.limits;
    float* __restrict good = in.good;
    float* __restrict angle = in.angle;
    float* __restrict intensity = in.intensity;
    float* __restrict width = in.width;
    float* __restrict sigma = in.sigma;
    std::uint8_t* __restrict flags = in.flags;
    const float* __restrict slopes = in.slope;
    const float* __restrict row_sigmas = in.row_sigma;
    const float* __restrict columns = in.columns;
    const float* __restrict lights = in.light;
    const float* __restrict column_widths = in.column_width;
    const float* __restrict backgrounds = in.background;
    WELD_PROFILER_APART
    for (int i = 0; i < in.count; ++i)
    {
      float slope = slopes[i];
      float light = lights[i];
      float column_width = column_widths[i];
      float held = columns[i];
      const float along = arcTangent(slope);
      const float cosine = 1.0F / __builtin_sqrtf(1.0F + slope * slope);
      const float across = column_width * cosine;
      const float room = limits.saturation - backgrounds[i];
      const float up = along - kHalfPi;
      const float down = along + kHalfPi;
      angle[i] = along > 0.0F ? up : down;
      intensity[i] = light < room ? light : room;
      width[i] = across;
      sigma[i] = row_sigmas[i] * cosine;
      const float bright = light >= limits.least_light ? light : 0.0F;
      const float clear = light * light * column_width >= limits.leastSquare() ? bright : 0.0F;
      const float wide = across >= limits.least_width ? clear : 0.0F;
      const float narrow = across <= limits.most_width ? wide : 0.0F;
      const float visible = room > 0.0F ? narrow : 0.0F;
      float row_sigma = row_sigmas[i];
      const float sure = row_sigma <= kUnsure * (column_width > kSampled ? column_width : kSampled) ? visible : 0.0F;
      good[i] = held > 0.0F ? sure : 0.0F;
    }
    for (int i = 0; i < in.count; ++i)
      flags[i] = static_cast<std::uint8_t>((in.peak[i] >= limits.saturation ? stripe_flag::kSaturated : 0) |
                                           (in.ambiguous[i] > 0.0F ? stripe_flag::kAmbiguous : 0));
  }
};
}  // namespace

void RidgeCentres::fill(const AlongStripe& along, Stripe& stripe, std::vector<std::uint16_t>& aperture) const
{
  const std::vector<SlotChoice::Slot>& chosen = choice_.chosen();
  stripe.resize(chosen.size());
  aperture.resize(chosen.size());
  // Slots that follow one another, which is nearly all of them, are copied at once.
  for (std::size_t begin = 0, end = 0; begin < chosen.size(); begin = end)
  {
    for (end = begin + 1; end < chosen.size() && chosen[end].slot == chosen[end - 1].slot + 1;)
      ++end;
    const int count = static_cast<int>(end - begin);
    const int cell = chosen[begin].cell;
    const float* columns = along.aperture().data() + chosen[begin].slot;
    std::uint16_t* cells = stripe.cell.data() + begin;
    float* u = stripe.u.data() + begin;
    std::uint16_t* apertures = aperture.data() + begin;
    for (int k = 0; k < count; ++k)
      cells[k] = static_cast<std::uint16_t>(cell + k);
    for (int k = 0; k < count; ++k)
      u[k] = static_cast<float>(cell + k);
    for (int k = 0; k < count; ++k)
      apertures[k] = static_cast<std::uint16_t>(static_cast<int>(columns[k]));
    const auto flags = flags_.begin() + chosen[begin].slot;
    std::copy(flags, flags + count, stripe.flags.begin() + static_cast<std::ptrdiff_t>(begin));
    const auto copy = [&](const std::vector<float>& values, std::vector<float>& to)
    {
      const auto from = values.begin() + chosen[begin].slot;
      std::copy(from, from + static_cast<std::ptrdiff_t>(end - begin), to.begin() + static_cast<std::ptrdiff_t>(begin));
    };
    copy(along.row(), stripe.v);
    copy(angle_, stripe.normal_angle);
    copy(intensity_, stripe.intensity);
    copy(width_, stripe.width);
    copy(sigma_, stripe.sigma);
  }
  for (std::size_t i = 0; i < chosen.size(); ++i)
    if (chosen[i].ambiguous)
      stripe.flags[i] |= stripe_flag::kAmbiguous;
}

void RidgeCentres::trace(const ColumnTrack& track, std::vector<InitialPoint>& initial) const
{
  for (const SlotChoice::Slot& chosen : choice_.chosen())
  {
    InitialPoint point;
    point.u = point.block_u = static_cast<float>(chosen.cell);
    point.v = track.v[chosen.slot] + track.core[chosen.slot];
    point.block_v = std::round(point.v);
    initial.push_back(point);
  }
}

void RidgeCentres::write(const ColumnTrack& track, const AlongStripe& along, const StripeLimits& limits, int cells,
                         Stripe& stripe, std::vector<std::uint16_t>& aperture)
{
  for (std::vector<float>* field : { &good_, &angle_, &intensity_, &width_, &sigma_ })
    field->resize(track.slots());
  flags_.resize(track.slots());
  const Finish::In in{ static_cast<int>(track.slots()),
                       limits,
                       along.slope().data(),
                       along.sigma().data(),
                       along.aperture().data(),
                       track.light.data(),
                       track.sigma.data(),
                       track.background.data(),
                       track.peak.data(),
                       track.ambiguous.data(),
                       good_.data(),
                       angle_.data(),
                       intensity_.data(),
                       width_.data(),
                       sigma_.data(),
                       flags_.data() };
  dispatch<Finish>(in);
  choice_.choose(track, good_, cells);
  fill(along, stripe, aperture);
  flagSteepLinks(stripe, kBesideUpright);
}
}  // namespace weld_profiler
