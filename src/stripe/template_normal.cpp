#include "template_normal.h"

#include <cmath>

#include "axis.h"

namespace weld_profiler
{
namespace
{
/// Moments of the gray in a template, about its block.
struct Moments
{
  double gray = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
  double square = 0.0;  ///< sum(I^2)
};

template <class Pixel>
Moments templateMoments(const ImageView& image, double count, const Block& block)
{
  Moments sum;
  for (int y = -kTemplateReach; y <= kTemplateReach; ++y)
  {
    const Pixel* row = image.row<Pixel>(block.v + y) + block.u;
    for (int x = -kTemplateReach; x <= kTemplateReach; ++x)
    {
      const double gray = row[x] / count;
      sum.gray += gray;
      sum.x += gray * x;
      sum.y += gray * y;
      sum.xx += gray * x * x;
      sum.xy += gray * x * y;
      sum.yy += gray * y * y;
      sum.square += gray * gray;
    }
  }
  return sum;
}

Moments momentsOf(const ImageView& image, const Levels& levels, const Block& block)
{
  return withPixel(image, [&](auto pixel) { return templateMoments<decltype(pixel)>(image, levels.count, block); });
}

TemplateNormal oriented(double u, double v)
{
  const double length = std::hypot(u, v);
  const double sign = v < 0.0 || (v == 0.0 && u < 0.0) ? -1.0 : 1.0;
  return TemplateNormal{ true, sign * u / length, sign * v / length };
}
}  // namespace

bool holdsTemplate(const ImageView& image, const Block& block)
{
  return block.u >= kTemplateReach && block.v >= kTemplateReach && block.u < image.width - kTemplateReach &&
         block.v < image.height - kTemplateReach;
}

TemplateNormal svdNormal(const ImageView& image, const Levels& levels, const Block& block)
{
  const Moments sum = momentsOf(image, levels, block);
  if (!(std::hypot(sum.x, sum.y) > kLeastMoment * (kTemplateCoordinates + sum.square)))
    return {};
  return oriented(sum.x, sum.y);
}

TemplateNormal pcaNormal(const ImageView& image, const Levels& levels, const Block& block)
{
  const Moments sum = momentsOf(image, levels, block);
  if (!(sum.gray > 0.0))
    return {};
  const double x = sum.x / sum.gray;
  const double y = sum.y / sum.gray;
  const double xx = sum.xx / sum.gray - x * x;
  const double xy = sum.xy / sum.gray - x * y;
  const double yy = sum.yy / sum.gray - y * y;
  TemplateNormal normal{ true };
  const double difference = smallerAxis(xx - yy, 2.0 * xy, normal.u, normal.v);
  return difference > kLeastAnisotropy * (xx + yy) ? normal : TemplateNormal{};
}
}  // namespace weld_profiler
