#pragma once

#include <cstddef>

#include "weld_profiler/core/stripe.h"

namespace weld_profiler
{
/// Where the line goes on nearly upright, several centres belong in a column: flags those next to it ambiguous.
/// @param beside  centres on either side that a method may draw toward it.
void flagSteepLinks(Stripe& stripe, std::size_t beside);
}  // namespace weld_profiler
