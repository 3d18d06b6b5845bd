#include "centroid.h"

#include "centroid_kernels.h"

namespace weld_profiler
{
void ColumnCentroid::measure(const Task& task, const ColumnTrack& track)
{
  for (std::vector<float>& array : arrays_)
    array.assign(track.slots(), 0.0F);
  for (const ColumnTrack::Piece& piece : track.pieces)
  {
    const auto slot = static_cast<std::size_t>(piece.slot);
    const auto at = [&](Array array) { return arrays_[array].data() + slot; };
    const CentroidStrip strip{ task.image,
                               piece.cell,
                               piece.count,
                               &track.v[slot],
                               &track.sigma[slot],
                               &track.background[slot],
                               &track.gradient[slot],
                               at(Shift),
                               at(Half),
                               at(Weight),
                               at(Second),
                               at(Amplitude),
                               at(ReadSigma),
                               at(Brightest) };
    withPixel(task.image,
              [&](auto pixel)
              {
                using Pixel = decltype(pixel);
                if (task.weight == CentroidWeight::SquaredGray)
                  dispatchLanes<MeasureCentroids<Pixel, true>>(strip);
                else
                  dispatchLanes<MeasureCentroids<Pixel, false>>(strip);
              });
  }
  finish(task, track);
}

void ColumnCentroid::finish(const Task& task, const ColumnTrack& track)
{
  const FinishCentroids::In in{ static_cast<int>(track.slots()),
                                task.weight == CentroidWeight::SquaredGray,
                                task.least,
                                task.saturation,
                                track.light.data(),
                                track.weight.data(),
                                track.sigma.data(),
                                track.background.data(),
                                track.gradient.data(),
                                arrays_[Shift].data(),
                                arrays_[Half].data(),
                                arrays_[Weight].data(),
                                arrays_[Second].data(),
                                arrays_[Light].data(),
                                arrays_[Sigma].data(),
                                arrays_[Amplitude].data(),
                                arrays_[ReadSigma].data() };
  dispatch<FinishCentroids>(in);
}

void ColumnCentroid::write(const ColumnTrack& track, const std::vector<SlotChoice::Slot>& slots, float saturation,
                           std::vector<Centre>& centres) const
{
  centres.resize(slots.size());
  for (std::size_t i = 0; i < slots.size(); ++i)
  {
    const auto slot = static_cast<std::size_t>(slots[i].slot);
    const double shift = arrays_[Shift][slot];
    Centre& centre = centres[i];
    centre = Centre{};
    centre.cell = slots[i].cell;
    centre.u = slots[i].cell;
    centre.v = track.v[slot] + shift;
    centre.initial_v = centre.v;
    centre.sigma_column = arrays_[Sigma][slot];
    centre.background = track.background[slot] + track.gradient[slot] * shift;
    centre.gradient = track.gradient[slot];
    centre.amplitude = arrays_[Amplitude][slot];
    centre.read_sigma = arrays_[ReadSigma][slot];
    centre.initial_sigma = centre.read_sigma;
    centre.starts_piece = slots[i].starts_piece;
    centre.saturated = arrays_[Brightest][slot] >= saturation;
    centre.ambiguous = slots[i].ambiguous || track.ambiguous[slot] > 0.0F;
  }
}
}  // namespace weld_profiler
