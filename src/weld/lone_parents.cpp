#include "lone_parents.h"

#include <algorithm>
#include <cmath>

#include "statistics.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kCertain = 2.0;      // sigmas of a bend that is no noise
constexpr double kOutlier = 4.0;      // scatters off the line: spatter, not a bend
constexpr double kMostFreedom = 3.0;  // that a few independent points are widened by at most

double energyOf(const ParentFit& fit)
{
  return square(fit.scatter) * fit.correlated_cells;
}

/// A line takes two of the independent points away: of m so few the scatter is seen too small by (m - 2) / m.
double fewPoints(const ParentFit& fit)
{
  const double independent = static_cast<double>(fit.points) / fit.correlated_cells;
  return independent > 2.0 ? std::min(kMostFreedom, independent / (independent - 2.0)) : kMostFreedom;
}

/// Curvature of a parent's piece beyond what noise makes [1/m].
double bendOf(const SectionProfile& profile, const ParentFit& fit)
{
  const double middle = 0.5 * (fit.inner + fit.outer), half = 0.5 * std::abs(fit.outer - fit.inner);
  double product = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < profile.size(); ++i)
  {
    const double u = (profile.q[i] - middle) / half, off = profile.z[i] - fit.line.at(profile.q[i]);
    if (std::abs(u) > 1.0 || std::abs(off) > kOutlier * fit.scatter)
      continue;
    const double shape = u * u - 1.0 / 3.0;  // what a line leaves of a parabola
    product += off * shape;
    squares += shape * shape;
  }
  if (!(squares > 0.0))
    return 0.0;
  const double bend = product / squares;
  const double noise = energyOf(fit) / squares;
  return 2.0 * std::sqrt(std::max(0.0, bend * bend - square(kCertain) * noise)) / square(half);
}

void widen(const SectionProfile& profile, const ParentFit& other, ParentFit& fit)
{
  double factor = fewPoints(fit);
  if (other.valid() && other.points > fit.points)
    factor = std::max(factor, energyOf(other) / energyOf(fit));
  fit.covariance *= factor;
  fit.covariance(1, 1) += square(bendOf(profile, fit) * fit.middle);  // the weld's middle lies at q = 0
}
}  // namespace

void widenParents(const SectionProfile& profile, SectionShape& shape)
{
  const ParentFit left = shape.left, right = shape.right;
  if (left.valid())
    widen(profile, right, shape.left);
  if (right.valid())
    widen(profile, left, shape.right);
}
}  // namespace weld
}  // namespace weld_profiler
