#include "undercut_flank.h"

#include <algorithm>
#include <cmath>

#include "statistics.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kOutward = 1.3e-3;        // the undercut's bottom is looked for this far outside the toe [m]
constexpr double kInward = 5e-4;           // ... and this far inside of where the toe was thought to be [m]
constexpr double kLeastDepth = 4e-5;       // [m]
constexpr double kLow = 0.8, kHigh = 0.2;  // of the depth: the piece of the flank that is continued
constexpr double kDoubt = 4e-5;            // 1-sigma [m]
}  // namespace

Quantity flankToe(const std::vector<Eigen::Vector2d>& points, double toe, double scatter)
{
  Quantity result;
  std::size_t bottom = points.size();
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const double u = points[i].x();
    if (u > toe - kOutward && u < toe + kInward && (bottom == points.size() || points[i].y() < points[bottom].y()))
      bottom = i;
  }
  if (bottom == points.size() || -points[bottom].y() < std::max(kLeastDepth, 8.0 * scatter))
    return result;
  const double depth = -points[bottom].y();
  double n = 0.0, u = 0.0, h = 0.0, uu = 0.0, uh = 0.0;
  for (std::size_t i = bottom; i < points.size() && points[i].y() < -kHigh * depth; ++i)
  {
    if (points[i].y() < -kLow * depth)
      continue;
    const double d = points[i].x() - toe;
    n += 1.0, u += d, h += points[i].y(), uu += d * d, uh += d * points[i].y();
  }
  const double spread = n * uu - u * u;
  if (n < 3.0 || !(spread > 0.0))
    return result;
  const double slope = (n * uh - u * h) / spread;
  if (!(slope > 0.1))
    return result;
  result.value = toe + u / n - h / n / slope;
  result.sigma = kDoubt;
  return result;
}
}  // namespace weld
}  // namespace weld_profiler
