#include "literal_reading.h"

#include <cmath>

#include "detector.h"
#include "frame_statistics.h"
#include "kernel_choice.h"
#include "median_filter.h"
#include "taylor_step.h"

namespace weld_profiler
{
namespace
{
/// 1-sigma of a result across the stripe: the step, counted twice, misses by as much as the centre lies from the middle
/// of its pixel block, which is anything within half a pixel (docs/paper.md measures 0.27 to 0.42). [px]
const double kMiss = 1.0 / std::sqrt(12.0);
constexpr double kPixel = 0.2887;  ///< 1-sigma half width of one row of pixels: 1 / sqrt(12) [px]
constexpr double kTear = 3.0;      ///< rows from which neighbouring columns are not one piece

/// Eq. 4 over the pixels of a column that lie above the threshold.
template <class Pixel>
bool maskedCentroid(const ImageView& image, const Levels& levels, double threshold, Centre& centre)
{
  double weight = 0.0;
  double moment = 0.0;
  double second = 0.0;
  double top = 0.0;
  for (int v = 0; v < image.height; ++v)
  {
    const double gray = image.row<Pixel>(v)[centre.cell];
    if (!(gray >= threshold))
      continue;
    weight += gray * gray;
    moment += gray * gray * v;
    second += gray * gray * v * v;
    top = std::max(top, gray);
  }
  if (!(weight > 0.0))
    return false;
  centre.v = moment / weight;
  // One row alone is as wide as a pixel.
  centre.sigma_column = std::max(kPixel, std::sqrt(2.0 * std::max(0.0, second / weight - centre.v * centre.v)));
  centre.amplitude = top - centre.background;
  centre.saturated = top >= levels.saturation;
  return true;
}
}  // namespace

void LiteralReading::extract(const ImageView& image, const StripeHint& hint, Workspace& workspace, Stripe& stripe) const
{
  Workspace::Scratch& scratch = workspace.scratch();
  stripe.clear();
  workspace.initial.clear();
  stripe.direction = Direction::AlongU;
  stripe.status = detectStripe(image, params_, hint, scratch);
  if (stripe.status != StripeStatus::Ok)
    return;
  const Levels levels = levelsOf(image, params_);
  ImageView filtered;
  medianFilter(image, params_.median_size_px, scratch.filtered, filtered);
  FrameStatistics statistics;
  measureFrame(filtered, levels, statistics);
  scratch.centres.clear();
  for (int u = 0; u < image.width; ++u)
  {
    Centre centre;
    centre.cell = u;
    centre.u = u;
    centre.background = statistics.background;
    const bool found =
        withPixel(filtered, [&](auto pixel)
                  { return maskedCentroid<decltype(pixel)>(filtered, levels, statistics.otsu, centre); });
    if (!found)
      continue;
    centre.initial_v = centre.v;
    centre.starts_piece = scratch.centres.empty() || std::abs(centre.v - scratch.centres.back().v) > kTear;
    scratch.centres.push_back(centre);
  }
  measureSlopes(scratch.centres);
  refine(filtered, scratch);
  finish(params_, levels, workspace, stripe);
}

void LiteralReading::refine(const ImageView& filtered, Workspace::Scratch& scratch) const
{
  chooseKernel(params_, scratch.centres, scratch.widths, scratch.kernel);
  if (params_.derivatives == "sobel")
    scratch.kernel.setSobel(DerivativeKernel::Sobel::Unscaled);
  const Levels levels = levelsOf(filtered, params_);
  std::size_t kept = 0;
  bool torn = false;
  for (Centre& centre : scratch.centres)
  {
    torn = torn || centre.starts_piece;
    const Block block{ centre.cell, static_cast<int>(std::lround(centre.v)) };
    if (!holdsTemplate(filtered, block) || !scratch.kernel.holds(filtered, block.u, block.v))
      continue;
    const TemplateNormal normal = normal_(filtered, levels, block);
    if (!normal.defined)
      continue;
    const TaylorStep step = taylorStep(scratch.kernel.at(filtered, block.u, block.v), normal);
    if (!step.maximum || std::abs(step.t * normal.u) > kHalfPixel || std::abs(step.t * normal.v) > kHalfPixel)
      continue;
    centre.u += step.t * normal.u;
    centre.v += step.t * normal.v;
    centre.read_sigma = kMiss * std::sqrt(1.0 + centre.slope * centre.slope);
    centre.normal_u = normal.u;
    centre.normal_v = normal.v;
    centre.starts_piece = torn;
    torn = false;
    scratch.centres[kept++] = centre;
  }
  scratch.centres.resize(kept);
}
}  // namespace weld_profiler
