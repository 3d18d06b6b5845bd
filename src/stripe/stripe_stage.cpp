#include "weld_profiler/stripe/stripe_stage.h"

#include <algorithm>

#include "channel.h"
#include "direction.h"
#include "scratch.h"
#include "spline_repair.h"
#include "weld_profiler/core/errors.h"
#include "weld_profiler/stripe/stripe_methods.h"

namespace weld_profiler
{
namespace
{
constexpr int kLargestImage = 65535;     ///< a cell is 16 bit
constexpr double kDecidingShare = 0.25;  ///< of the cells that a stripe must fill to decide the direction
constexpr double kDecidingRatio = 2.0;   ///< by which it must be longer than what the other direction shows

/// Lengths that are told in pixels of the image, in pixels of a grid twice as coarse.
StripeParams halved(StripeParams params)
{
  params.min_stripe_width_px *= 0.5;
  params.max_stripe_width_px = std::max(0.5, 0.5 * params.max_stripe_width_px);
  params.hessian_sigma_px = params.hessian_sigma_px > 0.0 ? std::max(0.5, 0.5 * params.hessian_sigma_px) : 0.0;
  return params;
}

Region regionIn(const RawImage& image, const StripeParams& params)
{
  if (image.data == nullptr || image.width <= 0 || image.height <= 0)
    throw PreconditionError("image is " + std::to_string(image.width) + "x" + std::to_string(image.height) +
                            " px, must hold at least one pixel");
  if (image.width > kLargestImage || image.height > kLargestImage)
    throw PreconditionError("image is " + std::to_string(image.width) + "x" + std::to_string(image.height) +
                            " px, must not exceed 65535 px either way");
  if (params.roi_x >= image.width || params.roi_y >= image.height)
    throw PreconditionError("stripe/roi_x, roi_y is " + std::to_string(params.roi_x) + ", " +
                            std::to_string(params.roi_y) + ", must lie inside the image of " +
                            std::to_string(image.width) + "x" + std::to_string(image.height) + " px");
  Region region{ params.roi_x, params.roi_y, image.width - params.roi_x, image.height - params.roi_y };
  if (params.roi_width > 0)
    region.width = std::min(region.width, params.roi_width);
  if (params.roi_height > 0)
    region.height = std::min(region.height, params.roi_height);
  return region;
}

/// From pixels of the view to pixels of the image.
void toImage(const ChannelView& channel, Stripe& stripe, std::vector<InitialPoint>& initial)
{
  const auto pitch = static_cast<float>(channel.pitch);
  const auto to_u = [&](float u) { return static_cast<float>(channel.u + static_cast<double>(u) * channel.pitch); };
  const auto to_v = [&](float v) { return static_cast<float>(channel.v + static_cast<double>(v) * channel.pitch); };
  const bool same = channel.pitch == 1 && channel.u == 0.0 && channel.v == 0.0;
  if (same && channel.cell_u == 0 && channel.cell_v == 0)
    return;
  const int first_cell = stripe.direction == Direction::AlongU ? channel.cell_u : channel.cell_v;
  for (std::size_t i = 0; i < stripe.size(); ++i)
  {
    stripe.cell[i] = static_cast<std::uint16_t>(first_cell + stripe.cell[i] * channel.pitch);
    stripe.u[i] = to_u(stripe.u[i]);
    stripe.v[i] = to_v(stripe.v[i]);
    stripe.width[i] *= pitch;
    stripe.sigma[i] *= pitch;
  }
  for (InitialPoint& point : initial)
    point = InitialPoint{ to_u(point.block_u), to_v(point.block_v), to_u(point.u), to_v(point.v) };
}
}  // namespace

StripeStage::StripeStage(const StripeParams& params)
  : params_(params), extractor_(makeStripeExtractor(params)), every_second_pixel_(makeStripeExtractor(halved(params)))
{
}

void StripeStage::process(const RawImage& image, Workspace& workspace, Stripe& stripe) const
{
  Workspace::Scratch& scratch = workspace.scratch();
  const Region region = regionIn(image, params_);
  const ChannelView channel = selectChannel(image, region, params_.channel, scratch.channel);
  workspace.initial.clear();
  if (channel.view.empty())  // a region one pixel wide or high, without a photosite of that colour
  {
    stripe.clear();
    stripe.status = StripeStatus::NoStripe;
    stripe.direction = params_.direction == "v" ? Direction::AlongV : Direction::AlongU;
    return;
  }

  if (params_.direction != "auto")
    extractAlong(params_.direction == "u" ? Direction::AlongU : Direction::AlongV, channel.view, channel.pitch,
                 workspace, stripe);
  else if (workspace.direction)
    extractAlong(*workspace.direction, channel.view, channel.pitch, workspace, stripe);
  else
    extractAnyDirection(channel.view, channel.pitch, workspace, stripe);
  toImage(channel, stripe, workspace.initial);

  const bool along_u = stripe.direction == Direction::AlongU;
  RepairSettings repair;
  repair.max_gap_px = params_.max_gap_px;
  repair.edge_trim_px = params_.edge_trim_px;
  repair.pitch = channel.pitch;
  repair.first_cell = along_u ? region.x : region.y;
  repair.last_cell = along_u ? region.x + region.width - 1 : region.y + region.height - 1;
  repair.interpolating = params_.taylor == "literal";
  repairGaps(repair, stripe, scratch.other);
}

void StripeStage::extractAlong(Direction direction, const ImageView& view, int pitch, Workspace& workspace,
                               Stripe& stripe) const
{
  const StripeExtractor& extractor = pitch == 1 ? *extractor_ : *every_second_pixel_;
  ImageView turned = view;
  if (direction == Direction::AlongV)
    transpose(view, workspace.scratch().transposed, turned);
  StripeHint hint;
  if (workspace.direction == direction || params_.direction != "auto")
    hint.last = &workspace.last;
  extractor.extract(turned, hint, workspace, stripe);
  workspace.last.cell = stripe.cell;
  workspace.last.v = stripe.v;
  if (direction == Direction::AlongU)
    return;
  transpose(stripe);
  for (InitialPoint& point : workspace.initial)
    point = InitialPoint{ point.block_v, point.block_u, point.v, point.u };
}

/// Extracts both ways and keeps the one that shows more line. Which it was is remembered only if it is beyond doubt: a
/// speck in the first frame must not decide for all that follow.
void StripeStage::extractAnyDirection(const ImageView& view, int pitch, Workspace& workspace, Stripe& stripe) const
{
  Workspace::Scratch& scratch = workspace.scratch();
  extractAlong(Direction::AlongU, view, pitch, workspace, stripe);
  scratch.other_initial.swap(workspace.initial);
  extractAlong(Direction::AlongV, view, pitch, workspace, scratch.other);
  if (lengthAlong(scratch.other) > lengthAlong(stripe))
    std::swap(stripe, scratch.other);
  else
    scratch.other_initial.swap(workspace.initial);
  const int cells = stripe.direction == Direction::AlongU ? view.width : view.height;
  const bool long_enough = static_cast<double>(stripe.size()) >= kDecidingShare * cells;
  if (long_enough && lengthAlong(stripe) >= kDecidingRatio * lengthAlong(scratch.other))
    workspace.direction = stripe.direction;
}
}  // namespace weld_profiler
