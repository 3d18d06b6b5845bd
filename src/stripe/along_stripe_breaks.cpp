#include <algorithm>
#include <cmath>

#include "along_stripe.h"
#include "aperture_kernels.h"

// What AlongStripe does beside columns without a centre. All else is loops over every slot; here are few.
namespace weld_profiler
{
namespace
{
constexpr int kGuard = ColumnTrack::kGuard;
constexpr int kSide = 13;      // columns on either side of a mean over 27
constexpr float kNine = 8.5F;  // columns held, of nine: fewer than all
}  // namespace

/// Slots with a centre, of the 27 columns around which one is missing.
void AlongStripe::findBreaks(const ColumnTrack& track)
{
  constexpr int kBlock = 64;  // slots that are passed over at once
  constexpr float kWhole = 26.5F;
  const float* held = at(Sum27);
  beside_breaks_.clear();
  for (int begin = kGuard; begin < slots_ - kGuard; begin += kBlock)
  {
    const int end = std::min(begin + kBlock, slots_ - kGuard);
    int missing = 0;
    for (int i = begin; i < end; ++i)
      missing |= held[i] > kWhole ? 0 : 1;
    for (int i = begin; missing != 0 && i < end; ++i)
      if (held[i] <= kWhole && track.weight[static_cast<std::size_t>(i)] > 0.0F)
        beside_breaks_.push_back(i);
  }
}

void AlongStripe::prepareBreaks(const ColumnTrack& track)
{
  std::fill(arrays_[Faded].begin(), arrays_[Faded].end(), 0.0F);
  std::fill(arrays_[Unsure].begin(), arrays_[Unsure].end(), 0.0F);
  findBreaks(track);
  for (const int slot : beside_breaks_)
    if (at(Sum9)[slot] < kNine)
      turnAtBreak(track, slot);
  for (const int slot : beside_breaks_)
    if (!atBorder(track, slot))
      takeFading(track, slot);
}

/// Where the image ends, not the light.
bool AlongStripe::atBorder(const ColumnTrack& track, int slot)
{
  for (const ColumnTrack::Piece& piece : track.pieces)
  {
    const int first = slot - piece.slot;
    const int last = piece.slot + piece.count - 1 - slot;
    if (first >= 0 && last >= 0)
      return (piece.cell == 0 && first <= kSide) || (piece.cell + piece.count == track.columns && last <= kSide);
  }
  return false;
}

/// Beside a break the reference line may lead anywhere: the slope is that of the columns up to it, on a parabola as far
/// as they are bent beyond doubt.
void AlongStripe::turnAtBreak(const ColumnTrack& track, int slot)
{
  constexpr int kReach = 8;
  constexpr int kLeast = 5;
  const float* weight = track.weight.data() + slot;
  int before = 0;
  int after = 0;
  while (before < kReach && weight[-before - 1] > 0.0F)
    ++before;
  while (after < kReach && weight[after + 1] > 0.0F)
    ++after;
  if (std::min(before, after) >= 4 || before + after + 1 < kLeast)
    return;
  // A parabola by least squares, in polynomials that are orthogonal over evenly spaced columns.
  const auto count = static_cast<float>(before + after + 1);
  const float middle = 0.5F * static_cast<float>(after - before);
  const float mean_square = (count * count - 1.0F) / 12.0F;
  float first = 0.0F;
  float second = 0.0F;
  float second_square = 0.0F;
  float sum = 0.0F;
  float squares = 0.0F;
  const float here = at(Offset)[slot];
  for (int k = -before; k <= after; ++k)
  {
    const float t = static_cast<float>(k) - middle;
    const float q = t * t - mean_square;
    const float row = at(Offset)[slot + k] - here;
    first += t * row;
    second += q * row;
    second_square += q * q;
    sum += row;
    squares += row * row;
  }
  const float first_square = mean_square * count;
  const float rest = squares - sum * sum / count - first * first / first_square - second * second / second_square;
  const float variance = std::max(rest, 0.0F) / std::max(1.0F, count - 3.0F);
  const float bent = sureOf(second / second_square, variance / second_square);
  const float slope = first / first_square - 2.0F * middle * bent;
  slope_[static_cast<std::size_t>(slot)] = at(SpareB)[slot] = slope;
}

/// Where the light fades out toward a break, what that feigns is taken off whole: no scatter along the stripe could
/// tell it, and the slope is that of the columns farther in.
void AlongStripe::takeFading(const ColumnTrack& track, int slot)
{
  constexpr int kNear = 8;  // columns from the break within which it fades
  constexpr float kFaded = 0.5F;
  constexpr float kFading = 0.95F;
  const float* weight = track.weight.data() + slot;
  const float* light = track.light.data() + slot;
  const float* slope = slope_.data() + slot;
  int after = kSide + 1;  // distance of the next column that is missing
  int before = kSide + 1;
  for (int k = kSide; k >= 1; --k)
  {
    after = weight[k] > 0.0F ? after : k;
    before = weight[-k] > 0.0F ? before : k;
  }
  if (std::min(after, before) > kNear || std::max(after, before) <= kSide)
    return;
  const int inward = after < before ? -1 : 1;
  const float* last = light - inward * (std::min(after, before) - 1);
  float full = 0.0F;
  for (int k = kNear; k <= kSide; ++k)
    full += light[inward * k] / static_cast<float>(kSide - kNear + 1);
  const bool falls = last[0] < last[inward] && last[inward] < last[2 * inward];
  if (!falls || last[0] > kFaded * full || light[0] > kFading * full)
    return;
  const bool bent = weight[inward * 2 * kNear] > 0.0F && weight[inward * (2 * kNear + 4)] > 0.0F;
  const float rise = slope[inward * kNear] + (bent ? slope[inward * kNear] - slope[inward * 2 * kNear] : 0.0F);
  // The last column's neighbour holds no light.
  const float right = weight[1] > 0.0F ? light[1] : 0.0F;
  const float left = weight[-1] > 0.0F ? light[-1] : 0.0F;
  const float change = 0.5F * (right - left) / std::max(light[0], 1e-3F);
  const float width = track.sigma.data()[slot + inward * kNear];
  const float feigned = width * width * rise / (1.0F + rise * rise) * change;
  slope_[static_cast<std::size_t>(slot)] = at(SpareB)[slot] = rise;
  at(Offset)[slot] -= feigned;
  at(Feigned)[slot] = 0.0F;
  at(Faded)[slot] = feigned;
}

void AlongStripe::bendBreaks(const ColumnTrack& track)
{
  for (const int slot : beside_breaks_)
    bendAtBreak(track, slot);
}

/// What curvature adds to the means over columns that are not spread evenly about a slot: half the second derivative
/// times their mean square distance, less what the mean slope has taken off already. It is known a little further in.
void AlongStripe::bendAtBreak(const ColumnTrack& track, int slot)
{
  constexpr int kFarther = 9;
  constexpr float kChanging = 0.3F;  // of what a change of the curvature makes of a mean over 9
  constexpr float kHalf = 4.5F;
  constexpr float kWhole = 8.5F;
  const float* held = at(Sum9);
  const auto known = [&](int i, float most) { return std::min({ held[i - 9], held[i], held[i + 9] }) > most; };
  if (known(slot, kHalf))
    return;
  int from = 0;
  for (int k = 1; k <= kSide && from == 0; ++k)
    from = known(slot + k, kWhole) ? k : (known(slot - k, kWhole) ? -k : 0);
  if (from == 0)
    return;
  // As much of it as there is a little farther in as well.
  const float near = at(Bend)[slot + from];
  const int farther = slot + from + (from > 0 ? kFarther : -kFarther);
  const float beyond = known(farther, kWhole) ? at(Bend)[farther] : near;
  const float least = std::min(std::abs(near), std::abs(beyond));
  const float bend = near * beyond > 0.0F ? std::copysign(least, near) : 0.0F;
  const auto moment = [&](int reach)
  {
    float count = 0.0F;
    float distance = 0.0F;
    float square = 0.0F;
    for (int k = -reach; k <= reach; ++k)
    {
      const float weight = track.weight.data()[slot + k];
      const auto x = static_cast<float>(k);
      count += weight, distance += weight * x, square += weight * x * x;
    }
    const float mean = distance / count;
    return 0.5F * square / count - (reach > 1 ? mean * mean : 0.0F);
  };
  const float moment9 = moment(4);
  const float mean3 = at(Mean3)[slot] - bend * moment(1);
  const float mean9 = at(Mean9)[slot] - bend * moment9;
  const float mean27 = at(Mean27)[slot] - bend * moment(kSide);
  at(Unsure)[slot] = kChanging * std::abs((near - beyond) * moment9);
  at(SpareA)[slot] = mean3, at(SpareB)[slot] = mean9, at(SpareC)[slot] = mean27;
  at(Bend)[slot] = bend;
  at(Square9)[slot] = (mean3 - mean9) * (mean3 - mean9);
  at(Square27)[slot] = (mean9 - mean27) * (mean9 - mean27);
}

void AlongStripe::tellBreaks(const ColumnTrack& track)
{
  for (const int slot : beside_breaks_)
  {
    if (at(Sum9)[slot] < kNine)
      tellLost(track, slot);
    tellFaded(slot);
  }
}

/// Where the light ends within a stripe's width, the last columns hold a part of its profile alone.
void AlongStripe::tellLost(const ColumnTrack& track, int slot)
{
  constexpr float kShift = 0.8F;  // half widths, of a column that holds no light, against its neighbours
  constexpr int kSide = 4;
  if (at(Faded)[slot] != 0.0F)
    return;  // known better
  const float* weight = track.weight.data() + slot;
  const float* lights = track.light.data() + slot;
  float light = 0.0F;
  for (int k = -kSide; k <= kSide; ++k)
    light += weight[k] > 0.0F ? lights[k] : 0.0F;
  light /= at(Sum9)[slot];
  float lost = 0.0F;
  for (int k = -1; k <= 1; ++k)
    lost += weight[k] > 0.0F ? std::max(0.0F, 1.0F - lights[k] / light) : 0.0F;
  lost /= std::max(1.0F, at(Sum3)[slot]);
  float& sigma = sigma_[static_cast<std::size_t>(slot)];
  sigma = std::hypot(sigma, kShift * track.sigma[static_cast<std::size_t>(slot)] * lost);
}

void AlongStripe::tellFaded(int slot)
{
  constexpr float kLeft = 0.25F;  // of what was taken off
  constexpr int kReach = 4;       // a mean over 9
  const float* faded = at(Faded) + slot;
  float largest = 0.0F;
  for (int k = -kReach; k <= kReach; ++k)
    largest = std::max(largest, std::abs(faded[k]) / (1.0F + 0.5F * static_cast<float>(std::abs(k))));
  float& sigma = sigma_[static_cast<std::size_t>(slot)];
  sigma = std::sqrt(sigma * sigma + kLeft * kLeft * largest * largest + at(Unsure)[slot] * at(Unsure)[slot]);
}
}  // namespace weld_profiler
