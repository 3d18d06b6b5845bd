#include "ridge_centres.h"

#include <algorithm>
#include <cmath>

#include "multiversion.h"

namespace weld_profiler
{
namespace
{
constexpr float kLightOverNoise = 4.0F;  // half the chance of one false column in 30 000
constexpr float kNearlyAsGood = 0.5F;    // light, of the better, from which a second piece in a cell is worth a flag
constexpr float kSteepest = 2.5F;        // rows a column, between neighbouring centres: 68 deg
constexpr float kUprightGap = 8.0F;      // columns that an upright piece may leave without a centre
constexpr int kLeastCells = 5;           // of one piece
constexpr int kSmallGap = 3;             // cells that may be missing inside a piece
constexpr float kHalfPi = 1.57079625F;   // the largest float that is not beyond

/// To 1e-5 rad: M. Abramowitz, I. Stegun, Handbook of Mathematical Functions, 4.4.49, and atan(x) + atan(1 / x) = pi/2.
WELD_PROFILER_KERNEL float arcTangent(float x)
{
  const float size = __builtin_fabsf(x);
  const float inverse = 1.0F / (size > 1.0F ? size : 1.0F);
  const float argument = size > 1.0F ? inverse : size;
  const float square = argument * argument;
  const float angle =
      argument * (0.999866F +
                  square * (-0.3302995F + square * (0.180141F + square * (-0.085133F + square * 0.0208351F))));
  const float rest = kHalfPi - angle;
  const float whole = size > 1.0F ? rest : angle;
  return __builtin_copysignf(whole, x);
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
    const float noise = kLightOverNoise * limits.noise;
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
      const float clear = light * light * column_width >= noise * noise ? bright : 0.0F;
      const float wide = across >= limits.least_width ? clear : 0.0F;
      const float narrow = across <= limits.most_width ? wide : 0.0F;
      good[i] = held > 0.0F ? narrow : 0.0F;
    }
    for (int i = 0; i < in.count; ++i)
      flags[i] = static_cast<std::uint8_t>((in.peak[i] >= limits.saturation ? stripe_flag::kSaturated : 0) |
                                           (in.ambiguous[i] > 0.0F ? stripe_flag::kAmbiguous : 0));
  }
};
}  // namespace

/// Of two pieces that overlap in a cell the brighter stays.
void RidgeCentres::chooseSlots(const ColumnTrack& track, int cells)
{
  slots_.assign(static_cast<std::size_t>(cells), -1);
  for (const ColumnTrack::Piece& piece : track.pieces)
    for (int k = 0; k < piece.count; ++k)
    {
      const int slot = piece.slot + k;
      if (!(good_[slot] > 0.0F))
        continue;
      int& chosen = slots_[piece.cell + k];
      if (chosen >= 0)
      {
        const int dimmer = good_[chosen] < good_[slot] ? chosen : slot;
        const int brighter = dimmer == slot ? chosen : slot;
        const bool close = good_[dimmer] > kNearlyAsGood * good_[brighter];
        flags_[brighter] |= close ? stripe_flag::kAmbiguous : 0;
        chosen = brighter;
      }
      else
        chosen = slot;
    }
}

/// Copies what was measured in cells [first, first + count), whose slots follow one another.
void RidgeCentres::copy(const AlongStripe& along, const Run& run, Stripe& stripe,
                        std::vector<std::uint16_t>& aperture) const
{
  const auto slot = static_cast<std::ptrdiff_t>(run.slot);
  const auto from = [&](const std::vector<float>& values, std::vector<float>& to)
  { std::copy_n(values.begin() + slot, run.count, to.begin() + static_cast<std::ptrdiff_t>(run.to)); };
  for (int k = 0; k < run.count; ++k)
  {
    const std::size_t to = run.to + static_cast<std::size_t>(k);
    stripe.cell[to] = static_cast<std::uint16_t>(run.cell + k);
    stripe.u[to] = static_cast<float>(run.cell + k);
    aperture[to] = static_cast<std::uint16_t>(along.aperture()[static_cast<std::size_t>(run.slot + k)]);
  }
  from(along.row(), stripe.v);
  from(angle_, stripe.normal_angle);
  from(intensity_, stripe.intensity);
  from(width_, stripe.width);
  from(sigma_, stripe.sigma);
  std::copy_n(flags_.begin() + slot, run.count, stripe.flags.begin() + static_cast<std::ptrdiff_t>(run.to));
}

/// @return how many centres were written; short pieces are not.
std::size_t RidgeCentres::append(const AlongStripe& along, Stripe& stripe, std::vector<std::uint16_t>& aperture) const
{
  const int cells = static_cast<int>(slots_.size());
  std::size_t count = 0;
  std::size_t piece = 0;
  int last = -kSmallGap - 2;
  for (int cell = 0; cell < cells;)
  {
    if (slots_[static_cast<std::size_t>(cell)] < 0)
    {
      ++cell;
      continue;
    }
    if (cell - last > kSmallGap + 1)
    {
      count = count - piece < kLeastCells ? piece : count;
      piece = count;
    }
    Run run{ cell, slots_[static_cast<std::size_t>(cell)], 1, count };
    while (cell + run.count < cells && slots_[static_cast<std::size_t>(cell + run.count)] == run.slot + run.count)
      ++run.count;
    copy(along, run, stripe, aperture);
    count += static_cast<std::size_t>(run.count);
    cell += run.count;
    last = cell - 1;
  }
  return count - piece < kLeastCells ? piece : count;
}

void RidgeCentres::trace(const ColumnTrack& track, const Stripe& stripe, std::vector<InitialPoint>& initial) const
{
  for (std::size_t i = 0; i < stripe.size(); ++i)
  {
    const int slot = slots_[stripe.cell[i]];
    InitialPoint point;
    point.u = point.block_u = stripe.u[i];
    point.v = track.v[slot] + track.core[slot];
    point.block_v = std::round(point.v);
    initial.push_back(point);
  }
}

/// Where the line goes on nearly upright, several centres belong in a column: those next to it are not to be trusted.
void RidgeCentres::flagSteepLinks(Stripe& stripe)
{
  constexpr std::size_t kBeside = 3;
  const std::size_t count = stripe.size();
  for (std::size_t i = 1; i < count; ++i)
  {
    const float columns = stripe.u[i] - stripe.u[i - 1];
    if (!(std::abs(stripe.v[i] - stripe.v[i - 1]) > kSteepest * columns) || columns > kUprightGap)
      continue;
    for (std::size_t k = i > kBeside ? i - kBeside : 0; k < std::min(count, i + kBeside); ++k)
      stripe.flags[k] |= stripe_flag::kAmbiguous;
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
  chooseSlots(track, cells);
  stripe.resize(static_cast<std::size_t>(cells));
  aperture.resize(static_cast<std::size_t>(cells));
  const std::size_t count = append(along, stripe, aperture);
  stripe.resize(count);
  aperture.resize(count);
  flagSteepLinks(stripe);
}
}  // namespace weld_profiler
