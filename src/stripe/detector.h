#pragma once

#include "scratch.h"
#include "weld_profiler/core/stripe.h"
#include "weld_profiler/stripe/stripe_extractor.h"

namespace weld_profiler
{
/// Where the stripe is: fills scratch.track, its reference line and half width evened out along the stripe, every
/// column measured about them.
/// @return Ok, or why there is no stripe: the track has no pieces then.
/// @param hint  see StripeFinder::find().
StripeStatus detectStripe(const ImageView& image, const StripeParams& params, const StripeHint& hint,
                          Workspace::Scratch& scratch);

/// Why a frame shows no stripe: too bright, too dark, or none there.
StripeStatus reasonForNone(const ImageView& image, const StripeParams& params);
}  // namespace weld_profiler
