#include "band_tiles.h"

#include <algorithm>

#include "lanes.h"
#include "pixels.h"

namespace weld_profiler
{
namespace
{
constexpr int kMostRows = 48;  ///< by which a stripe may rise in a tile: a steep one's tiles are narrow

struct Convert
{
  template <class Pixel>
  WELD_PROFILER_KERNEL static void run(const Pixel* pixels, int count, float* __restrict gray)
  {
    for (int i = 0; i < count; ++i)
      gray[i] = static_cast<float>(pixels[i]);
  }
};
}  // namespace

void BandTiles::reset(const ImageView& image, const Sites& sites, int reach)
{
  image_ = image;
  sites_ = &sites;
  reach_ = reach;
  begin_ = 0;
}

bool BandTiles::next()
{
  const Sites& sites = *sites_;
  if (begin_ == sites.size())
    return false;
  const std::size_t begin = begin_;
  int top = sites[begin].v;
  int bottom = top;
  std::size_t end = begin;
  for (; end < sites.size() && sites[end].u - sites[begin].u < kMostRunColumns; ++end)
  {
    const int highest = std::min(top, sites[end].v);
    const int lowest = std::max(bottom, sites[end].v);
    if (lowest - highest >= kMostRows)
      break;
    top = highest;
    bottom = lowest;
  }
  listRuns(begin, end, top, bottom);
  left_ = sites[begin].u - reach_;
  top_ = top - reach_;
  convert(sites[end - 1].u - sites[begin].u + 1 + 2 * reach_, bottom - top + 1 + 2 * reach_);
  begin_ = end;
  return true;
}

void BandTiles::listRuns(std::size_t begin, std::size_t end, int top, int bottom)
{
  runs_.assign(static_cast<std::size_t>(bottom - top) + 1, RowRun{ 0, end, 0 });
  for (std::size_t i = begin; i < end; ++i)
  {
    const Site& site = (*sites_)[i];
    RowRun& run = runs_[static_cast<std::size_t>(site.v - top)];
    run.row = site.v;
    run.first = std::min(run.first, i);
    run.last = i;
  }
  runs_.erase(std::remove_if(runs_.begin(), runs_.end(), [end](const RowRun& run) { return run.first == end; }),
              runs_.end());
}

void BandTiles::convert(int columns, int rows)
{
  pitch_ = columns + kMostLanes;
  gray_.resize(std::max(gray_.size(), static_cast<std::size_t>(pitch_) * static_cast<std::size_t>(rows)));
  withPixel(image_,
            [&](auto pixel)
            {
              for (int j = 0; j < rows; ++j)
                dispatch<Convert>(image_.row<decltype(pixel)>(top_ + j) + left_, columns, gray_.data() + j * pitch_);
            });
}
}  // namespace weld_profiler
