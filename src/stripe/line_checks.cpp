#include "line_checks.h"

#include <algorithm>
#include <cmath>

namespace weld_profiler
{
namespace
{
constexpr float kSteepest = 2.5F;  // rows a column
constexpr int kBreak = 16;         // cells
constexpr std::size_t kBeside = 6;
constexpr std::size_t kAway = 5;        // centres from the link, to where the width is the stripe's own
constexpr float kSwollen = 1.35F;       // times that width
constexpr std::uint8_t kDropped = 128;  // while the checks run

bool isUpright(const Stripe& stripe, std::size_t i)
{
  const int cells = stripe.cell[i] - stripe.cell[i - 1];
  return cells <= kBreak && std::abs(stripe.v[i] - stripe.v[i - 1]) > kSteepest * static_cast<float>(cells);
}

/// @param step  away from the link, 1 or -1.
void markBeside(Stripe& stripe, std::size_t first, int step)
{
  const auto at = [&](std::size_t k)
  { return static_cast<std::ptrdiff_t>(first) + static_cast<std::ptrdiff_t>(k) * step; };
  const auto holds = [&](std::ptrdiff_t i) { return i >= 0 && i < static_cast<std::ptrdiff_t>(stripe.size()); };
  const float own = holds(at(kBeside + kAway)) ? stripe.width[static_cast<std::size_t>(at(kBeside + kAway))] : 0.0F;
  for (std::size_t k = 0; k < kBeside && holds(at(k)); ++k)
  {
    const auto i = static_cast<std::size_t>(at(k));
    const bool swollen = own > 0.0F && stripe.width[i] > kSwollen * own;
    stripe.flags[i] |= swollen ? kDropped : stripe_flag::kAmbiguous;
  }
}

void dropMarked(Stripe& stripe)
{
  std::size_t kept = 0;
  for (std::size_t i = 0; i < stripe.size(); ++i)
    if ((stripe.flags[i] & kDropped) == 0)
    {
      if (kept != i)
        stripe.set(kept, stripe[i]);
      ++kept;
    }
  stripe.resize(kept);
}
}  // namespace

void checkUprightLinks(Stripe& stripe)
{
  bool any = false;
  for (std::size_t i = 1; i < stripe.size(); ++i)
    if (isUpright(stripe, i))
    {
      markBeside(stripe, i - 1, -1);
      markBeside(stripe, i, 1);
      any = true;
    }
  if (any)
    dropMarked(stripe);
}

void dropLoneCentres(Stripe& stripe)
{
  constexpr int kApart = 4;  // cells
  constexpr std::size_t kCompany = 3;
  bool any = false;
  for (std::size_t begin = 0, end = 0; begin < stripe.size(); begin = end)
  {
    for (end = begin + 1; end < stripe.size() && stripe.cell[end] - stripe.cell[end - 1] <= kApart;)
      ++end;
    for (std::size_t i = begin; i < end && end - begin < kCompany; ++i)
    {
      stripe.flags[i] |= kDropped;
      any = true;
    }
  }
  if (any)
    dropMarked(stripe);
}
}  // namespace weld_profiler
