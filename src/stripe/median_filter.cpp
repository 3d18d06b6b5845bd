#include "median_filter.h"

#include <cstring>
#include <opencv2/imgproc.hpp>

namespace weld_profiler
{
namespace
{
int matType(const ImageView& image)
{
  return image.bit_depth == 8 ? CV_8UC1 : CV_16UC1;
}

std::size_t pixelBytes(const ImageView& image)
{
  return image.bit_depth == 8 ? 1 : 2;
}

/// A view of packed rows in memory, of the image's size and depth.
ImageView packedLike(const ImageView& image, std::vector<std::uint8_t>& memory)
{
  ImageView view = image;
  view.step = static_cast<std::size_t>(image.width) * pixelBytes(image);
  memory.resize(view.step * static_cast<std::size_t>(image.height));
  view.data = memory.data();
  return view;
}

cv::Mat asMat(const ImageView& view)
{
  // cv::Mat knows no constant pixels; sources are only read.
  return { view.height, view.width, matType(view), const_cast<std::uint8_t*>(view.data), view.step };
}
}  // namespace

void medianFilter(const ImageView& image, int size, std::vector<std::uint8_t>& memory, ImageView& filtered)
{
  filtered = packedLike(image, memory);
  cv::Mat result = asMat(filtered);
  if (size == 0)
    asMat(image).copyTo(result);
  else
    cv::medianBlur(asMat(image), result, size);
}

void TiledMedian::reset(const ImageView& image, int size)
{
  image_ = image;
  size_ = size;
  tiles_u_ = (image.width + kTileColumns - 1) / kTileColumns;
  tiles_v_ = (image.height + kTileRows - 1) / kTileRows;
  requested_.assign(static_cast<std::size_t>(tiles_u_) * static_cast<std::size_t>(tiles_v_), 0);
  filtered_ = size == 0 ? image : packedLike(image, memory_);
}

void TiledMedian::request(int u, int tile_row)
{
  requested_[static_cast<std::size_t>(tile_row * tiles_u_ + u / kTileColumns)] = 1;
}

void TiledMedian::filter()
{
  if (size_ == 0)
    return;
  for (int tile_row = 0; tile_row < tiles_v_; ++tile_row)
  {
    const std::uint8_t* requested = requested_.data() + static_cast<std::ptrdiff_t>(tile_row) * tiles_u_;
    for (int first = 0; first < tiles_u_; ++first)
    {
      if (requested[first] == 0)
        continue;
      int last = first;
      while (last + 1 < tiles_u_ && requested[last + 1] != 0)
        ++last;
      filterSpan(tile_row, first, last);
      first = last;
    }
  }
}

void TiledMedian::filterSpan(int tile_row, int first_tile, int last_tile)
{
  const int reach = size_ / 2;
  const cv::Rect whole(0, 0, image_.width, image_.height);
  const cv::Rect inner = whole & cv::Rect(first_tile * kTileColumns, tile_row * kTileRows,
                                          (last_tile - first_tile + 1) * kTileColumns, kTileRows);
  const cv::Rect outer =
      whole & cv::Rect(inner.x - reach, inner.y - reach, inner.width + 2 * reach, inner.height + 2 * reach);
  const std::size_t bytes = pixelBytes(image_);
  const std::size_t needed = static_cast<std::size_t>(outer.width) * static_cast<std::size_t>(outer.height) * bytes;
  if (span_.size() < needed)
    span_.resize(needed);
  cv::Mat span(outer.height, outer.width, matType(image_), span_.data());
  cv::medianBlur(asMat(image_)(outer), span, size_);
  const cv::Rect cut(inner.x - outer.x, inner.y - outer.y, inner.width, inner.height);
  for (int v = 0; v < inner.height; ++v)
    std::memcpy(memory_.data() + static_cast<std::size_t>(inner.y + v) * filtered_.step +
                    static_cast<std::size_t>(inner.x) * bytes,
                span.ptr(cut.y + v) + static_cast<std::size_t>(cut.x) * bytes,
                static_cast<std::size_t>(inner.width) * bytes);
}
}  // namespace weld_profiler
