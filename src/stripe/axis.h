#pragma once

#include <cmath>

#include "multiversion.h"

namespace weld_profiler
{
/// Unit eigenvector of the smaller eigenvalue of [[xx, xy], [xy, yy]]; of the two opposite ones that with v > 0, or
/// v = 0 and u > 0.
///
/// The larger eigenvalue's axis lies at half the angle of (xx - yy, 2 xy), this one at a right angle to it. The half
/// angle's cosine and sine follow without trigonometry, each from the formula that does not cancel.
/// @param difference  xx - yy
/// @param twice       2 xy
/// @return the length of (difference, twice); where it is 0, u and v are no numbers.
template <class Real>
WELD_PROFILER_KERNEL Real smallerAxis(Real difference, Real twice, Real& u, Real& v)
{
  constexpr Real kHalf = 0.5;
  const Real length = std::sqrt(difference * difference + twice * twice);
  const Real larger = std::sqrt(kHalf + kHalf * std::abs(difference) / length);
  const Real smaller = kHalf * std::abs(twice) / (length * larger);
  const Real across = difference > 0 ? smaller : larger;
  u = twice > 0 ? -across : across;
  v = difference > 0 ? larger : smaller;
  return length;
}
}  // namespace weld_profiler
