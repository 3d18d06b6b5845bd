#include "steep_links.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace weld_profiler
{
void flagSteepLinks(Stripe& stripe, std::size_t beside)
{
  constexpr float kSteepest = 2.5F;  // rows a column, between neighbouring centres: 68 deg
  constexpr int kUprightGap = 8;     // columns that an upright piece may leave without a centre
  const std::size_t count = stripe.size();
  // Nearly all stripes end here, and this loop the compiler vectorises.
  const float* v = stripe.v.data();
  int steep = 0;
  for (std::size_t i = 1; i < count; ++i)
    steep |= std::abs(v[i] - v[i - 1]) > kSteepest ? 1 : 0;
  if (steep == 0)
    return;
  for (std::size_t i = 1; i < count; ++i)
  {
    const int columns = stripe.cell[i] - stripe.cell[i - 1];
    if (columns > kUprightGap || !(std::abs(stripe.v[i] - stripe.v[i - 1]) > kSteepest * static_cast<float>(columns)))
      continue;
    for (std::size_t k = i > beside ? i - beside : 0; k < std::min(count, i + beside); ++k)
      stripe.flags[k] |= stripe_flag::kAmbiguous;
  }
}
}  // namespace weld_profiler
