#include "ridge_centres.h"

#include <cmath>

#include "multiversion.h"

namespace weld_profiler
{
namespace
{
constexpr float kHalfPi = 1.57079625F;  // the largest float that is not beyond

/// To 1e-5 rad: M. Abramowitz, I. Stegun, Handbook of Mathematical Functions, 4.4.49, and atan(x) + atan(1 / x) = pi/2.
WELD_PROFILER_KERNEL float arcTangent(float x)
{
  const float size = x < 0.0F ? -x : x;
  const float argument = size > 1.0F ? 1.0F / size : size;
  const float square = argument * argument;
  const float angle =
      argument *
      (0.999866F + square * (-0.3302995F + square * (0.180141F + square * (-0.085133F + square * 0.0208351F))));
  const float whole = size > 1.0F ? kHalfPi - angle : angle;
  return x < 0.0F ? -whole : whole;
}

struct Finish
{
  struct In
  {
    int count;
    RidgeCentres::Limits limits;
    const float *slope, *row_sigma, *columns, *light, *column_width, *background, *peak, *ambiguous;
    float *good, *angle, *intensity, *width, *sigma;
    std::uint8_t* flags;
  };
  WELD_PROFILER_KERNEL static void run(In in)
  {
    const RidgeCentres::Limits limits = in.limits;
    float* __restrict good = in.good;
    float* __restrict angle = in.angle;
    float* __restrict intensity = in.intensity;
    float* __restrict width = in.width;
    float* __restrict sigma = in.sigma;
    std::uint8_t* __restrict flags = in.flags;
    for (int i = 0; i < in.count; ++i)
    {
      const float slope = in.slope[i];
      const float along = arcTangent(slope);
      const float cosine = 1.0F / __builtin_sqrtf(1.0F + slope * slope);
      const float light = in.light[i];
      const float across = in.column_width[i] * cosine;
      const float room = limits.saturation - in.background[i];
      angle[i] = along > 0.0F ? along - kHalfPi : along + kHalfPi;
      intensity[i] = light < room ? light : room;
      width[i] = across;
      sigma[i] = in.row_sigma[i] * cosine;
      const bool bright = light >= limits.least.light && light * light * in.column_width[i] >= limits.least.square();
      const bool wide = across >= limits.least_width && across <= limits.most_width;
      good[i] = in.columns[i] > 0.0F && room > 0.0F && bright && wide ? light : 0.0F;
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
  for (std::size_t i = 0; i < chosen.size(); ++i)
  {
    const int slot = chosen[i].slot;
    stripe.cell[i] = static_cast<std::uint16_t>(chosen[i].cell);
    stripe.u[i] = static_cast<float>(chosen[i].cell);
    stripe.v[i] = along.row()[slot];
    stripe.normal_angle[i] = angle_[slot];
    stripe.intensity[i] = intensity_[slot];
    stripe.width[i] = width_[slot];
    stripe.sigma[i] = sigma_[slot];
    stripe.flags[i] = flags_[slot] | (chosen[i].ambiguous ? stripe_flag::kAmbiguous : 0);
    aperture[i] = static_cast<std::uint16_t>(along.aperture()[slot]);
  }
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

void RidgeCentres::write(const ColumnTrack& track, const AlongStripe& along, const Limits& limits, int cells,
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
}
}  // namespace weld_profiler
