#include "taylor_step.h"

#include <cmath>

namespace weld_profiler
{
namespace
{
constexpr int kMoves = 2;                ///< pixels that an initial point may be off
constexpr double kBetweenPixels = 0.55;  ///< accepted where the step swings between two pixels: a second-order step to
                                         ///< a centre half-way between them is a little longer than 1/2 from either
constexpr double kFarthest =
    1.0;  ///< rows that the step may take the line off its initial point; beyond, the normal is wrong
}  // namespace

TaylorStep taylorStep(const Derivatives& d, const TemplateNormal& n)
{
  TaylorStep step;
  const double slope = n.u * d.x + n.v * d.y;
  step.curvature = n.u * n.u * d.xx + 2.0 * n.u * n.v * d.xy + n.v * n.v * d.yy;
  step.maximum = step.curvature < 0.0;
  step.t = step.maximum ? -slope / step.curvature : 0.0;
  return step;
}

TemplateNormal hessianNormal(const Derivatives& d)
{
  const double difference = std::hypot(d.xx - d.yy, 2.0 * d.xy);
  if (!(difference > 0.0))
    return {};
  // Half the angle of (xx - yy, 2 xy) is the axis of the larger eigenvalue; the more negative one lies at a right
  // angle.
  const double larger = 0.5 * std::atan2(2.0 * d.xy, d.xx - d.yy);
  const double angle = d.xx + d.yy < 0.0 ? larger + 0.5 * std::acos(-1.0) : larger;
  TemplateNormal normal{ true, std::cos(angle), std::sin(angle) };
  if (normal.v < 0.0 || (normal.v == 0.0 && normal.u < 0.0))
    normal = TemplateNormal{ true, -normal.u, -normal.v };
  return normal;
}

bool stepToCentre(const ImageView& image, const DerivativeKernel& kernel, const TemplateNormal* normal, double noise,
                  Centre& centre)
{
  int block = static_cast<int>(std::lround(centre.v));
  int before = block;
  for (int move = 0; move <= kMoves; ++move)
  {
    if (!kernel.holds(image, centre.cell, block))
      return false;
    const Derivatives derivatives = kernel.at(image, centre.cell, block);
    const TemplateNormal across = normal != nullptr ? *normal : hessianNormal(derivatives);
    const TaylorStep step = across.defined ? taylorStep(derivatives, across) : TaylorStep{};
    if (!step.maximum)
      return false;
    const int next = block + (step.t * across.v > 0.0 ? 1 : -1);
    const bool swings = move > 0 && next == before;
    if (std::abs(step.t) <= (swings ? kBetweenPixels : kHalfPixel))
    {
      const double row = block + step.t * across.v - centre.slope * step.t * across.u;
      if (std::abs(row - centre.v) > kFarthest)
        return false;
      centre.u = centre.cell + step.t * across.u;
      centre.v = block + step.t * across.v;
      centre.normal_u = across.u;
      centre.normal_v = across.v;
      const double sigma = noise * kernel.noiseGain() / std::abs(step.curvature);
      centre.read_sigma = sigma * std::sqrt(1.0 + centre.slope * centre.slope);
      return true;
    }
    if (swings)
      return false;  // the normal is far off
    before = block;
    block = next;
  }
  return false;
}
}  // namespace weld_profiler
