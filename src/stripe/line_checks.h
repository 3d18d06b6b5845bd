#pragma once

#include "weld_profiler/core/stripe.h"

namespace weld_profiler
{
/// Where the line goes on nearly upright, steeper than 68 deg from one centre to the next or over a break of at most 8
/// cells, a column holds several centres: three either side are flagged ambiguous.
void flagSteepLinks(Stripe& stripe);

/// Leaves out what has no line about it: fewer than 3 centres with no other within 4 cells.
void dropLoneCentres(Stripe& stripe);
}  // namespace weld_profiler
