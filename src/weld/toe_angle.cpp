#include <cmath>

#include "toe_fit.h"

namespace weld_profiler
{
namespace weld
{
namespace
{
constexpr double kAngleSigmas = 1.2;  // the arc is a model: ripples and real faces depart from it
constexpr int kAngleSamples = 64;
constexpr double kAngleFace = 1e-3;        // interfaces: the face's first millimetre ...
constexpr double kAngleShare = 1.0 / 3.0;  // ... or third of height
}  // namespace

Quantity toeAngle(const ToeFit& toe, Side side, const Line& parent, double height)
{
  if (toe.bridged || !std::isfinite(height))
    return Quantity();
  const double inward = -sign(side);
  const Line line{ parent.height, inward * parent.slope };
  const double begin = inward * toe.q;
  const double step = kAngleFace / kAngleSamples;
  double n = 0.0, u = 0.0, z = 0.0, uu = 0.0, uz = 0.0, length = 0.0, last = toe.z;
  double reached = 0.0;
  for (int i = 0; i <= kAngleSamples; ++i)
  {
    const double d = i * step;
    const double at = toe.face.heightAt(begin + d);
    length += i > 0 ? std::hypot(step, at - last) : 0.0;
    last = at;
    if (!std::isfinite(at) || length > kAngleFace || line.above(begin + d, at) > kAngleShare * height)
      break;
    n += 1.0, u += d, z += at, uu += d * d, uz += d * at;
    reached = d;
  }
  const Eigen::Vector2d middle(begin + 0.5 * reached, toe.face.heightAt(begin + 0.5 * reached));
  const double spread = n * uu - u * u;
  double angle = toe.face.direction(middle);
  if (n > 2.5 && spread > 0.0)
    angle = std::atan((n * uz - u * z) / spread);
  Quantity result;
  result.value = 3.14159265358979323846 - (angle - std::atan(line.slope));
  result.sigma = kAngleSigmas * toe.face.sigmaDirection(middle, toe.energy);
  return result;
}
}  // namespace weld
}  // namespace weld_profiler
