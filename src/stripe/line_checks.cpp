#include "line_checks.h"

#include <algorithm>
#include <cmath>

namespace weld_profiler
{
void flagSteepLinks(Stripe& stripe)
{
  constexpr float kSteepest = 2.5F;  // rows a column
  constexpr int kBreak = 8;          // cells
  constexpr std::size_t kBeside = 3;
  const std::size_t count = stripe.size();
  for (std::size_t i = 1; i < count; ++i)
  {
    const int cells = stripe.cell[i] - stripe.cell[i - 1];
    if (!(std::abs(stripe.v[i] - stripe.v[i - 1]) > kSteepest * static_cast<float>(cells)) || cells > kBreak)
      continue;
    for (std::size_t k = i > kBeside ? i - kBeside : 0; k < std::min(count, i + kBeside); ++k)
      stripe.flags[k] |= stripe_flag::kAmbiguous;
  }
}

void dropLoneCentres(Stripe& stripe)
{
  constexpr int kAway = 4;
  constexpr std::size_t kCompany = 3;
  std::size_t kept = 0;
  for (std::size_t begin = 0, end = 0; begin < stripe.size(); begin = end)
  {
    for (end = begin + 1; end < stripe.size() && stripe.cell[end] - stripe.cell[end - 1] <= kAway;)
      ++end;
    if (end - begin < kCompany)
      continue;
    for (std::size_t i = begin; i < end; ++i, ++kept)
      if (kept != i)
        stripe.set(kept, stripe[i]);
  }
  stripe.resize(kept);
}
}  // namespace weld_profiler
