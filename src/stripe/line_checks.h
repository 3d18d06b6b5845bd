#pragma once

#include "weld_profiler/core/stripe.h"

namespace weld_profiler
{
/// Where the line goes on nearly upright, steeper than 68 deg from one centre to the next or over a break of at most 16
/// cells, a column holds several centres: six either side are flagged ambiguous, and left out where the light is wider
/// than the stripe is farther on: they lie between two parts of it.
void checkUprightLinks(Stripe& stripe);

/// Leaves out what has no line about it: fewer than 3 centres with no other within 4 cells.
void dropLoneCentres(Stripe& stripe);
}  // namespace weld_profiler
