#pragma once

#include <vector>

#include "centre.h"
#include "derivatives.h"
#include "weld_profiler/stripe/stripe_params.h"

namespace weld_profiler
{
/// The derivatives the parameters ask for, of a width that suits the centres' stripe.
void chooseKernel(const StripeParams& params, const std::vector<Centre>& centres, std::vector<double>& widths,
                  DerivativeKernel& kernel);
}  // namespace weld_profiler
