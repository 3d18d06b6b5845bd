#pragma once

#include <array>
#include <vector>

#include "band_tiles.h"
#include "lanes.h"
#include "pixels.h"
#include "template_normal.h"

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

  /// Of a run, down the columns of its templates, a value a column; vector code reads two vectors beyond.
  struct ColumnMoments
  {
    static constexpr int kCount = kMostRunColumns + kTemplateSize + 2 * kMostLanes;
    std::array<float, kCount> gray, y, yy, square;
  };

private:
  void measureMoments(const ImageView& image, const Sites& sites);
  void sumAlong(const Sites& sites, const RowRun& run, const ColumnMoments& sums);

  BandTiles tiles_;
  std::vector<ColumnMoments> sums_;  ///< of all runs of a tile
  /// Of the gray in each template, about its block, one value a site.
  std::vector<float> gray_, x_, y_, xx_, xy_, yy_, square_;
};
}  // namespace weld_profiler
