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
  stripe.resize(choice_.size());
  aperture.resize(choice_.size());
  std::ptrdiff_t to = 0;
  for (const SlotChoice::Run& run : choice_.runs())
  {
    const float* columns = along.aperture().data() + run.slot;
    std::uint16_t* cells = stripe.cell.data() + to;
    float* u = stripe.u.data() + to;
    std::uint16_t* apertures = aperture.data() + to;
    std::uint8_t* flags = stripe.flags.data() + to;
    const std::uint8_t* told = flags_.data() + run.slot;
    const std::uint8_t ambiguous = run.ambiguous ? stripe_flag::kAmbiguous : 0;
    for (int k = 0; k < run.count; ++k)
      cells[k] = static_cast<std::uint16_t>(run.cell + k);
    for (int k = 0; k < run.count; ++k)
      u[k] = static_cast<float>(run.cell + k);
    for (int k = 0; k < run.count; ++k)
      apertures[k] = static_cast<std::uint16_t>(static_cast<int>(columns[k]));
    for (int k = 0; k < run.count; ++k)
      flags[k] = static_cast<std::uint8_t>(told[k] | ambiguous);
    const auto copy = [&](const std::vector<float>& values, std::vector<float>& field)
    { std::copy_n(values.begin() + run.slot, run.count, field.begin() + to); };
    copy(along.row(), stripe.v);
    copy(angle_, stripe.normal_angle);
    copy(intensity_, stripe.intensity);
    copy(width_, stripe.width);
    copy(sigma_, stripe.sigma);
    to += run.count;
  }
}

void RidgeCentres::trace(const ColumnTrack& track, std::vector<InitialPoint>& initial) const
{
  for (const SlotChoice::Run& run : choice_.runs())
    for (int k = 0; k < run.count; ++k)
    {
      InitialPoint point;
      point.u = point.block_u = static_cast<float>(run.cell + k);
      point.v = track.v[run.slot + k] + track.core[run.slot + k];
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
