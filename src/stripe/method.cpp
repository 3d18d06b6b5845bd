#include "method.h"

#include <cmath>

#include "centre_line.h"
#include "detector.h"
#include "steep_links.h"

namespace weld_profiler
{
namespace
{
constexpr std::size_t kBesideUpright = 4;  ///< centres that a kernel of 2.3 px rounds a corner over
}  // namespace

void finish(const StripeParams& params, const Levels& levels, Workspace& workspace, Stripe& stripe)
{
  Workspace::Scratch& scratch = workspace.scratch();
  scratch.scatter.measure(scratch.centres);
  writeStripe(scratch.centres, scratch.scatter, params, levels, stripe);
  flagSteepLinks(stripe, kBesideUpright);
  if (stripe.empty())
    stripe.status = StripeStatus::NoStripe;
  if (!workspace.keep_trace)
    return;
  for (std::size_t i = 0, written = 0; written < stripe.size(); ++i)
  {
    const Centre& centre = scratch.centres[i];
    if (centre.cell != stripe.cell[written])
      continue;
    InitialPoint point;
    point.u = point.block_u = static_cast<float>(centre.cell);
    point.v = static_cast<float>(centre.initial_v);
    point.block_v = static_cast<float>(std::lround(centre.initial_v));
    workspace.initial.push_back(point);
    ++written;
  }
}

void MethodBase::extract(const ImageView& image, const StripeHint& hint, Workspace& workspace, Stripe& stripe) const
{
  Workspace::Scratch& scratch = workspace.scratch();
  stripe.clear();
  workspace.initial.clear();
  stripe.direction = Direction::AlongU;
  stripe.status = detectStripe(image, params_, hint, scratch);
  if (stripe.status != StripeStatus::Ok)
    return;
  const Levels levels = levelsOf(image, params_);
  const StripeLimits limits = limitsOf(params_, levels, scratch.finder.noise());
  scratch.centroid.measure({ image, limits, weight() }, scratch.track);
  scratch.choice.choose(scratch.track, scratch.centroid.light(), image.width);
  scratch.centroid.write(scratch.track, scratch.choice, limits.saturation, scratch.centres);
  measureSlopes(scratch.centres);
  refine(image, scratch);
  finish(params_, levels, workspace, stripe);
  if (stripe.empty())
    stripe.status = reasonForNone(image, params_);
}

void MethodBase::refine(const ImageView& /*image*/, Workspace::Scratch& /*scratch*/) const {}
}  // namespace weld_profiler
