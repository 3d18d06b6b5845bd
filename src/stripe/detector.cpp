#include "detector.h"

#include <algorithm>

namespace weld_profiler
{
namespace
{
constexpr double kOverexposed = 0.3;  ///< share of clipped pixels from which a frame without a stripe is too bright
constexpr int kLeastCells = 5;        ///< of one piece
constexpr double kLeastShare = 0.25;  ///< of all candidates' brightness in its columns; less is a pattern, no stripe

/// The line's share of what is bright in its columns: a stripe stands out, a row of a checkerboard does not.
double shareOfBrightness(const CandidateList& candidates, const std::vector<Seed>& seeds)
{
  double own = 0.0;
  double all = 0.0;
  for (const Seed& seed : seeds)
  {
    own += seed.brightness;
    all += candidates.total_brightness[static_cast<std::size_t>(seed.u)];
  }
  return all > 0.0 ? own / all : 0.0;
}

StripeStatus reason(const FrameStatistics& statistics, const Levels& levels, const StripeParams& params)
{
  if (statistics.saturated_share >= kOverexposed)
    return StripeStatus::TooBright;
  int brightest = kBins - 1;
  while (brightest > 0 && statistics.histogram[static_cast<std::size_t>(brightest)] == 0)
    --brightest;
  return brightest * levels.bin() < params.min_peak_counts * levels.count ? StripeStatus::TooDark
                                                                          : StripeStatus::NoStripe;
}
}  // namespace

StripeStatus reasonForNone(const ImageView& image, const Levels& levels, const StripeParams& params,
                           Workspace::Scratch& scratch)
{
  measureFrame(image, levels, scratch.statistics);
  return reason(scratch.statistics, levels, params);
}

StripeStatus detectStripe(const ImageView& image, const StripeParams& params, Workspace::Scratch& scratch)
{
  const Levels levels = levelsOf(image, params);
  measureFrame(image, levels, scratch.statistics);
  scratch.finder.find(image, params, scratch.statistics, scratch.candidates);
  scratch.tracker.choose(scratch.candidates, static_cast<float>(scratch.statistics.otsu), scratch.seeds);
  dropShortPieces(scratch.seeds, std::min(kLeastCells, image.width));
  if (shareOfBrightness(scratch.candidates, scratch.seeds) < kLeastShare)
    scratch.seeds.clear();
  return scratch.seeds.empty() ? reason(scratch.statistics, levels, params) : StripeStatus::Ok;
}
}  // namespace weld_profiler
