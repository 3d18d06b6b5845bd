#pragma once

#include <string>

#include "weld_profiler/core/image.h"
#include "weld_profiler/core/stripe.h"
#include "weld_profiler/stripe/stripe_params.h"

namespace weld_profiler
{
namespace fuzz
{
/// @return what the stripe breaks of what core/stripe.h and StripeStage promise of any image whatsoever; empty =
/// nothing.
std::string brokenPromise(const Stripe& stripe, const RawImage& image, const StripeParams& params);
}  // namespace fuzz
}  // namespace weld_profiler
