#include "method.h"

#include <cmath>

#include "centre_line.h"
#include "detector.h"

namespace weld_profiler
{
void keepTrace(const std::vector<Centre>& centres, Workspace& workspace)
{
  if (!workspace.keep_trace)
    return;
  for (const Centre& centre : centres)
  {
    InitialPoint point;
    point.block_u = static_cast<float>(centre.cell);
    point.block_v = static_cast<float>(std::lround(centre.v));
    point.u = static_cast<float>(centre.u);
    point.v = static_cast<float>(centre.v);
    workspace.initial.push_back(point);
  }
}

void MethodBase::extract(const ImageView& image, const StripeHint& /*hint*/, Workspace& workspace, Stripe& stripe) const
{
  // The whole frame is searched in less time than it takes to make sure that a hint has not gone stale.
  Workspace::Scratch& scratch = workspace.scratch();
  stripe.clear();
  workspace.initial.clear();
  stripe.direction = Direction::AlongU;
  stripe.status = detectStripe(image, params_, scratch);
  if (stripe.status != StripeStatus::Ok)
    return;
  const Levels levels = levelsOf(image, params_);
  scratch.centroid.measure(image, levels, scratch.statistics, weight(), scratch.seeds, scratch.centres);
  measureSlopes(scratch.centres);
  keepTrace(scratch.centres, workspace);
  refine(image, scratch);
  scratch.scatter.measure(scratch.centres);
  writeStripe(scratch.centres, scratch.scatter, params_, levels, stripe);
  if (stripe.empty())
    stripe.status = StripeStatus::NoStripe;
}

void MethodBase::refine(const ImageView& /*image*/, Workspace::Scratch& /*scratch*/) const {}
}  // namespace weld_profiler
