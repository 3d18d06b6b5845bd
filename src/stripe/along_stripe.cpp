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
  prepareBreaks(track);
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
  growth_.learn(track, at(Sum9), at(Slope9));
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
  bendBreaks(track);
  sum(Square9, 1, Mean3);
  sum(Mean3, 3, Mean9);
  sum(Mean9, 9, Seen9);
  sum(Square27, 1, Mean3);
  sum(Mean3, 3, Mean9);
  sum(Mean9, 9, Mean27);
  sum(Mean27, 9, Seen27);
}

void AlongStripe::choose(const ColumnTrack& track, int max_aperture)
{
  const ChooseAperture::In in{ slots_,
                               max_aperture,
                               variates_.stretches().data(),
                               growth_.perColumn().data(),
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
  tellBreaks(track);
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
