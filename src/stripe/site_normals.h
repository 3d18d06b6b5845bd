#pragma once

#include <vector>

#include "band_tiles.h"
#include "pixels.h"

namespace weld_profiler
{
/// svdNormal() and pcaNormal() of many templates at once. The moments are sums of whole numbers below 2^24, so single
/// precision holds them exactly, at 16 bit too.
class SiteNormals
{
public:
  /// @param sites  the template around each lies inside the image.
  void measureSvd(const ImageView& image, const Levels& levels, const Sites& sites);
  void measurePca(const ImageView& image, const Levels& levels, const Sites& sites);

  /// One value a site: unit, v > 0, or v = 0 and u > 0; (0, 0) = `normal undefined`.
  std::vector<float> u, v;

private:
  void measureMoments(const ImageView& image, const Sites& sites);

  BandTiles tiles_;
  /// Of the gray in each template, about its block, one value a site.
  std::vector<float> gray_, x_, y_, xx_, xy_, yy_, square_;
};
}  // namespace weld_profiler
