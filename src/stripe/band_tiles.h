#pragma once

#include <cstddef>
#include <vector>

#include "weld_profiler/core/image.h"

namespace weld_profiler
{
/// A pixel on the stripe at which a method looks.
struct Site
{
  std::size_t centre = 0;  ///< index of the centre that it belongs to
  int u = 0, v = 0;
};

/// The pixel block of a centre inside the image.
inline int nearestPixel(double place)
{
  return static_cast<int>(place + 0.5);
}

/// Sites in rising columns, at most one a column.
using Sites = std::vector<Site>;

/// A row with the sites first..last, of which those with that v are meant: what a filter that runs down the columns
/// first computes in one go. On a flat stripe it is as long as it may be, on a steep one a site or two.
struct RowRun
{
  int row = 0;
  std::size_t first = 0, last = 0;
};

constexpr int kMostRunColumns = 64;  ///< sites[last].u - sites[first].u of a run is less

/// Cuts the band around a stripe into tiles that stay in the cache, as numbers that vector code reads without another
/// thought: grey levels in single precision, any image's.
class BandTiles
{
public:
  /// Begins anew. @param sites  kept by the caller until the last tile.
  /// @param reach  rows and columns that the caller reads around each site, all inside the image.
  void reset(const ImageView& image, const Sites& sites, int reach);

  /// The next tile. @return false: there is none.
  bool next();

  /// Of the tile: every site belongs to one run.
  const std::vector<RowRun>& runs() const { return runs_; }

  /// The pixel (u, v) of the tile; up to kMostLanes - 1 more may be read at the end of a row.
  const float* at(int u, int v) const
  {
    return gray_.data() + static_cast<std::ptrdiff_t>(v - top_) * pitch_ + (u - left_);
  }
  std::ptrdiff_t pitch() const { return pitch_; }  ///< from row to row

private:
  void listRuns(std::size_t begin, std::size_t end, int top, int bottom);
  void convert(int columns, int rows);

  ImageView image_;
  const Sites* sites_ = nullptr;
  int reach_ = 0;
  std::size_t begin_ = 0;
  std::vector<RowRun> runs_;
  std::vector<float> gray_;
  int left_ = 0, top_ = 0;
  std::ptrdiff_t pitch_ = 0;
};
}  // namespace weld_profiler
