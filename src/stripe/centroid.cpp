#include "centroid.h"

#include "centroid_kernels.h"

namespace weld_profiler
{
void ColumnCentroid::measure(const Task& task, const ColumnTrack& track)
{
  for (std::vector<float>& array : arrays_)
    array.resize(track.slots());
  for (const ColumnTrack::Piece& piece : track.pieces)
  {
    const auto slot = static_cast<std::size_t>(piece.slot);
    const auto at = [&](Array array) { return arrays_[array].data() + slot; };
    const CentroidStrip strip{ task.image,
                               task.limits,
                               piece.cell,
                               piece.count,
                               &track.v[slot],
                               &track.sigma[slot],
                               &track.background[slot],
                               &track.gradient[slot],
                               &track.light[slot],
                               &track.weight[slot],
                               at(Light),
                               at(Shift),
                               at(Sigma),
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
}

void ColumnCentroid::write(const ColumnTrack& track, const SlotChoice& choice, float saturation,
                           std::vector<Centre>& centres) const
{
  centres.resize(choice.size());
  auto centre = centres.begin();
  for (const SlotChoice::Run& run : choice.runs())
    for (int k = 0; k < run.count; ++k, ++centre)
    {
      const auto slot = static_cast<std::size_t>(run.slot) + static_cast<std::size_t>(k);
      const double shift = arrays_[Shift][slot];
      *centre = Centre{};
      centre->cell = run.cell + k;
      centre->u = run.cell + k;
      centre->v = track.v[slot] + shift;
      centre->initial_v = centre->v;
      centre->sigma_column = arrays_[Sigma][slot];
      centre->background = track.background[slot] + track.gradient[slot] * shift;
      centre->gradient = track.gradient[slot];
      centre->amplitude = arrays_[Amplitude][slot];
      centre->read_sigma = arrays_[ReadSigma][slot];
      centre->initial_sigma = centre->read_sigma;
      centre->starts_piece = run.starts_piece && k == 0;
      centre->saturated = arrays_[Brightest][slot] >= saturation;
      centre->ambiguous = run.ambiguous || track.ambiguous[slot] > 0.0F;
    }
}
}  // namespace weld_profiler
