#include "detector.h"

#include "frame_statistics.h"

namespace weld_profiler
{
namespace
{
constexpr double kOverexposed = 0.3;  ///< share of clipped pixels from which a frame without a stripe is too bright
}  // namespace

StripeStatus reasonForNone(const ImageView& image, const StripeParams& params)
{
  const Levels levels = levelsOf(image, params);
  FrameStatistics statistics;
  measureFrame(image, levels, statistics);
  if (statistics.saturated_share >= kOverexposed)
    return StripeStatus::TooBright;
  int brightest = kBins - 1;
  while (brightest > 0 && statistics.histogram[static_cast<std::size_t>(brightest)] == 0)
    --brightest;
  return brightest * levels.bin() < params.min_peak_counts * levels.count ? StripeStatus::TooDark
                                                                          : StripeStatus::NoStripe;
}

StripeStatus detectStripe(const ImageView& image, const StripeParams& params, const StripeHint& hint,
                          Workspace::Scratch& scratch)
{
  ColumnTrack& track = scratch.track;
  track.pieces.clear();
  if (image.width >= kGroup)
    scratch.finder.find(image, static_cast<float>(params.min_peak_counts * levelsOf(image, params).count), hint.last,
                        track);
  if (track.pieces.empty())
    return reasonForNone(image, params);
  const float noise = scratch.finder.noise();
  ColumnMoments::locate(image, noise, track);
  scratch.along.settle(track);
  ColumnMoments::measure(image, noise, track);
  return StripeStatus::Ok;
}
}  // namespace weld_profiler
