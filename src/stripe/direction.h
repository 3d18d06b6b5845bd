#pragma once

#include <cstdint>
#include <vector>

#include "weld_profiler/core/image.h"
#include "weld_profiler/core/stripe.h"

namespace weld_profiler
{
/// Rows become columns: a stripe along the columns becomes one along the rows.
void transpose(const ImageView& image, std::vector<std::uint8_t>& memory, ImageView& transposed);

/// u becomes v, and the normals turn with them.
void transpose(Stripe& stripe);

/// How much line was found, seen along its direction: the larger of both tells which way the stripe runs. [px]
double lengthAlong(const Stripe& stripe);
}  // namespace weld_profiler
