#include "along_stripe.h"

#include <algorithm>
#include <cmath>

#include "along_stripe_kernels.h"
#include "multiversion.h"

namespace weld_profiler
{
namespace
{
constexpr int kGuard = ColumnTrack::kGuard;
constexpr float kLinear = 0.06F;  // half widths, as are the others
constexpr float kNear = 0.75F;
}  // namespace

void AlongStripe::resize(std::size_t slots)
{
  slots_ = static_cast<int>(slots);
  for (std::vector<float>& array : arrays_)
    array.resize(slots);
  for (std::vector<float>* array : { &slope_, &row_, &sigma_, &aperture_ })
    array->resize(slots);
}

void AlongStripe::sum(Array values, int lag, Array to)
{
  dispatch<SumOfThree>(at(values), lag, slots_, at(to));
}

void AlongStripe::countColumns(const ColumnTrack& track)
{
  dispatch<SumOfThree>(track.weight.data(), 1, slots_, at(Sum3));
  sum(Sum3, 3, Sum9);
  sum(Sum9, 9, Sum27);
  sum(Sum27, 9, Sum81);
  dispatch<LeverOfOne>(track.weight.data(), slots_, at(Lever3));
  dispatch<LeverOfThree>(at(Lever3), at(Sum3), 3, slots_, at(Lever9));
  dispatch<LeverOfThree>(at(Lever9), at(Sum9), 9, slots_, at(Lever27));
}

void AlongStripe::settle(ColumnTrack& track)
{
  resize(track.slots());
  countColumns(track);
  dispatch<Settling>(slots_, track.weight.data(), track.core.data(), track.spread.data(), at(Offset), at(Difference));
  sum(Offset, 1, Mean3);
  sum(Mean3, 3, Mean9);
  sum(Difference, 1, SpareA);
  sum(SpareA, 3, SpareB);
  sum(SpareB, 9, SpareC);
  const SettleReference::In in{ slots_,    at(Sum3),   at(Sum9),       at(Sum27),         at(Mean3),
                                at(Mean9), at(SpareC), track.v.data(), track.sigma.data() };
  dispatch<SettleReference>(in);
  for (const ColumnTrack::Piece& piece : track.pieces)
    track.layOn(piece);
}

void AlongStripe::prepareColumns(const ColumnTrack& track)
{
  const PrepareColumns::In in{ slots_,
                               track.v.data(),
                               track.sigma.data(),
                               track.light.data(),
                               track.weight.data(),
                               track.core.data(),
                               track.flanks.data(),
                               slope_.data(),
                               at(SpareB),
                               at(Feigned),
                               at(Difference),
                               at(Offset) };
  dispatch<PrepareColumns>(in);
  besideBreaks(track, Sum9, 8.5F, [&](int slot) { turnAtBreak(track, slot); });
}

/// Calls `use(slot)` for every measured column around which a sum of columns held is less than `whole`.
template <class Use>
void AlongStripe::besideBreaks(const ColumnTrack& track, Array sum, float whole, Use&& use) const
{
  constexpr int kBlock = 64;  // slots that are passed over at once
  const float* held = arrays_[sum].data();
  for (int begin = kGuard; begin < slots_ - kGuard; begin += kBlock)
  {
    const int end = std::min(begin + kBlock, slots_ - kGuard);
    int missing = 0;
    for (int i = begin; i < end; ++i)
      missing |= held[i] > whole ? 0 : 1;
    for (int i = begin; missing != 0 && i < end; ++i)
      if (held[i] <= whole && track.weight[static_cast<std::size_t>(i)] > 0.0F)
        use(i);
  }
}

/// Beside a break the reference line may lead anywhere: the slope is that of the columns up to it.
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
  for (int k = -before; k <= after; ++k)
  {
    const float t = static_cast<float>(k) - middle;
    const float q = t * t - mean_square;
    first += t * at(Offset)[slot + k];
    second += q * at(Offset)[slot + k];
    second_square += q * q;
  }
  const float slope = first / (mean_square * count) - 2.0F * middle * second / second_square;
  slope_[static_cast<std::size_t>(slot)] = at(SpareB)[slot] = slope;
}

void AlongStripe::meanSlopes()
{
  sum(SpareB, 1, SpareA);
  sum(SpareA, 3, SpareB);
  sum(SpareB, 9, SpareC);
  dispatch<MeanHeld>(at(SpareB), at(Sum9), slots_, at(Slope9));
  dispatch<MeanHeld>(at(SpareC), at(Sum27), slots_, at(Slope27));
}

void AlongStripe::meanAlong()
{
  sum(Offset, 1, SpareA);
  sum(SpareA, 3, SpareB);
  sum(SpareB, 9, SpareC);
  dispatch<MeanOf>(at(SpareA), at(Sum3), at(Lever3), slope_.data(), slots_, at(Mean3));
  dispatch<MeanOf>(at(SpareB), at(Sum9), at(Lever9), at(Slope9), slots_, at(Mean9));
  dispatch<MeanOf>(at(SpareC), at(Sum27), at(Lever27), at(Slope27), slots_, at(Mean27));
}

void AlongStripe::join(const ColumnTrack& track, int max_aperture)
{
  resize(track.slots());
  countColumns(track);
  prepareColumns(track);
  meanSlopes();
  sum(Offset, 1, SpareA);
  dispatch<MeanOf>(at(SpareA), at(Sum3), at(Lever3), slope_.data(), slots_, at(Mean3));
  sum(Feigned, 1, SpareA);
  dispatch<MeanHeld>(at(SpareA), at(Sum3), slots_, at(Feigned3));
  sum(Difference, 1, SpareA);
  dispatch<MeanHeld>(at(SpareA), at(Sum3), slots_, at(Difference3));
  variates_.learn(ControlVariates::Means{ at(Mean3), at(Feigned3), at(Difference3), track.light.data(), at(Sum3),
                                          at(Offset), track.sigma.data(), slots_, track.noise });
  const auto stretches = static_cast<int>(variates_.stretches().size());
  dispatch<Correct>(slots_, stretches, variates_.stretches().data(), at(Feigned), at(Difference), at(Offset));
  meanAlong();
  compareMeans(track);
  choose(track, max_aperture);
}

void AlongStripe::compareMeans(const ColumnTrack& track)
{
  const TakeBend::In in{ slots_,      variates_.stretches().data(),
                         at(Sum3),    at(Sum9),
                         at(Mean3),   at(Mean9),
                         at(Mean27),  at(SpareA),
                         at(SpareB),  at(SpareC),
                         at(Bend),    at(Square9),
                         at(Square27) };
  dispatch<TakeBend>(in);
  besideBreaks(track, Sum27, 26.5F, [&](int slot) { bendAtBreak(track, slot); });
  sum(Square9, 1, Mean3);
  sum(Mean3, 3, Mean9);
  sum(Mean9, 9, Seen9);
  sum(Square27, 1, Mean3);
  sum(Mean3, 3, Mean9);
  sum(Mean9, 9, Mean27);
  sum(Mean27, 9, Seen27);
}

/// What curvature adds to the means over columns that are not spread evenly about a slot: half the second derivative
/// times their mean square distance, less what the mean slope has taken off already. It is known a little further in.
void AlongStripe::bendAtBreak(const ColumnTrack& track, int slot)
{
  constexpr int kInward = 13;
  constexpr float kHalf = 4.5F;
  constexpr float kWhole = 8.5F;
  const float* held = at(Sum9);
  const auto known = [&](int i, float most) { return std::min({ held[i - 9], held[i], held[i + 9] }) > most; };
  if (known(slot, kHalf))
    return;
  int from = 0;
  for (int k = 1; k <= kInward && from == 0; ++k)
    from = known(slot + k, kWhole) ? k : (known(slot - k, kWhole) ? -k : 0);
  if (from == 0)
    return;
  const float bend = at(Bend)[slot + from];
  const auto added = [&](int reach)
  {
    float count = 0.0F;
    float distance = 0.0F;
    float square = 0.0F;
    for (int k = -reach; k <= reach; ++k)
    {
      const float weight = track.weight[static_cast<std::size_t>(slot + k)];
      const auto x = static_cast<float>(k);
      count += weight, distance += weight * x, square += weight * x * x;
    }
    const float mean = distance / count;
    return bend * (0.5F * square / count - (reach > 1 ? mean * mean : 0.0F));
  };
  const float mean3 = at(Mean3)[slot] - added(1);
  const float mean9 = at(Mean9)[slot] - added(4);
  const float mean27 = at(Mean27)[slot] - added(13);
  at(SpareA)[slot] = mean3, at(SpareB)[slot] = mean9, at(SpareC)[slot] = mean27;
  at(Bend)[slot] = bend;
  at(Square9)[slot] = (mean3 - mean9) * (mean3 - mean9);
  at(Square27)[slot] = (mean9 - mean27) * (mean9 - mean27);
}

void AlongStripe::choose(const ColumnTrack& track, int max_aperture)
{
  const ChooseAperture::In in{ slots_,
                               max_aperture,
                               variates_.stretches().data(),
                               track.weight.data(),
                               track.sigma.data(),
                               slope_.data(),
                               at(Sum3),
                               at(Sum9),
                               at(Sum27),
                               at(Sum81),
                               at(SpareA),
                               at(SpareB),
                               at(SpareC),
                               at(Seen9),
                               at(Seen27),
                               at(Bend),
                               at(Difference3),
                               row_.data(),
                               sigma_.data(),
                               aperture_.data() };
  dispatch<ChooseAperture>(in);
  tellEnds(track);
}

/// Where the light ends within a stripe's width, the last columns hold a part of its profile alone.
void AlongStripe::tellEnds(const ColumnTrack& track)
{
  constexpr float kShift = 0.8F;  // half widths, of a column that holds no light, against its neighbours
  constexpr int kSide = 4;
  besideBreaks(track, Sum9, 8.5F,
               [&](int i)
               {
                 float light = 0.0F;
                 for (int k = i - kSide; k <= i + kSide; ++k)
                   light += track.weight[k] > 0.0F ? track.light[k] : 0.0F;
                 light /= arrays_[Sum9][i];
                 float lost = 0.0F;
                 for (int k = i - 1; k <= i + 1; ++k)
                   lost += track.weight[k] > 0.0F ? std::max(0.0F, 1.0F - track.light[k] / light) : 0.0F;
                 lost /= std::max(1.0F, arrays_[Sum3][i]);
                 sigma_[i] = std::hypot(sigma_[i], kShift * track.sigma[i] * lost);
               });
}

bool AlongStripe::moveReference(ColumnTrack& track) const
{
  float farthest = 0.0F;
  dispatch<FarthestOff>(slots_, aperture_.data(), row_.data(), track.v.data(), track.sigma.data(), &farthest);
  const bool far = farthest > kLinear;
  if (!far)
    return false;
  for (int i = kGuard; i < slots_ - kGuard; ++i)
  {
    const bool near = aperture_[i] > 0.0F && std::abs(row_[i] - track.v[i]) < kNear * track.sigma[i];
    track.v[i] = near ? row_[i] : track.v[i];
  }
  for (const ColumnTrack::Piece& piece : track.pieces)
    track.layOn(piece);
  return true;
}
}  // namespace weld_profiler
