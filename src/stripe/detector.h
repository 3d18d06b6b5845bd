#pragma once

#include "scratch.h"
#include "weld_profiler/core/stripe.h"

namespace weld_profiler
{
/// Where the stripe is, to a pixel: fills scratch.seeds, at most one a column, and scratch.statistics.
/// @return Ok, or why there is no stripe: seeds are empty then.
StripeStatus detectStripe(const ImageView& image, const StripeParams& params, Workspace::Scratch& scratch);

/// Why a frame shows no stripe: too bright, too dark, or none there.
StripeStatus reasonForNone(const ImageView& image, const Levels& levels, const StripeParams& params,
                           Workspace::Scratch& scratch);
}  // namespace weld_profiler
