#include "median_filter.h"

#include <algorithm>
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

// __restrict (GCC, Clang): without the promise that the results overlap nothing these loops stay scalar, ten times
// slower.

template <class Pixel>
Pixel medianOfThree(Pixel a, Pixel b, Pixel c)
{
  return std::max(std::min(a, b), std::min(std::max(a, b), c));
}

/// The pixels of three rows, sorted column by column.
template <class Pixel>
void sortColumns(const Pixel* const (&rows)[3], int first, int count, Pixel* __restrict low, Pixel* __restrict middle,
                 Pixel* __restrict high)
{
  const Pixel* a = rows[0] + first;
  const Pixel* b = rows[1] + first;
  const Pixel* c = rows[2] + first;
  for (int i = 0; i < count; ++i)
  {
    low[i] = std::min(a[i], std::min(b[i], c[i]));
    middle[i] = medianOfThree(a[i], b[i], c[i]);
    high[i] = std::max(a[i], std::max(b[i], c[i]));
  }
}

template <class Pixel>
void combineColumns(const Pixel* low, const Pixel* middle, const Pixel* high, int count, Pixel* __restrict out)
{
  for (int i = 0; i < count; ++i)
    out[i] = medianOfThree(std::max(low[i], std::max(low[i + 1], low[i + 2])),
                           medianOfThree(middle[i], middle[i + 1], middle[i + 2]),
                           std::min(high[i], std::min(high[i + 1], high[i + 2])));
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
  requested_[static_cast<std::size_t>(tile_row) * static_cast<std::size_t>(tiles_u_) +
             static_cast<std::size_t>(u / kTileColumns)] = 1;
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
  Span span;
  span.u = first_tile * kTileColumns;
  span.v = tile_row * kTileRows;
  span.width = std::min(image_.width, (last_tile + 1) * kTileColumns) - span.u;
  span.height = std::min(image_.height, span.v + kTileRows) - span.v;
  withPixel(image_,
            [&](auto pixel)
            {
              using Pixel = decltype(pixel);
              if (size_ == 3)
                filterSpan3<Pixel>(span);
              else
                filterSpan5<Pixel>(span);
            });
}

/// Median of nine by sorted columns: the median of the largest low, the middle middle and the smallest high.
template <class Pixel>
void TiledMedian::filterSpan3(const Span& span)
{
  const int count = span.width + 2;  // a column more on either side
  sorted_.resize(3 * static_cast<std::size_t>(count) * sizeof(Pixel));
  auto* low = reinterpret_cast<Pixel*>(sorted_.data());
  Pixel* middle = low + count;
  Pixel* high = middle + count;
  for (int v = span.v; v < span.v + span.height; ++v)
  {
    const Pixel* rows[3] = { image_.row<Pixel>(std::max(0, v - 1)), image_.row<Pixel>(v),
                             image_.row<Pixel>(std::min(image_.height - 1, v + 1)) };
    sortColumns(rows, span.u, span.width, low + 1, middle + 1, high + 1);
    sortColumns(rows, std::max(0, span.u - 1), 1, low, middle, high);
    sortColumns(rows, std::min(image_.width - 1, span.u + span.width), 1, low + count - 1, middle + count - 1,
                high + count - 1);
    auto* out = reinterpret_cast<Pixel*>(memory_.data() + static_cast<std::size_t>(v) * filtered_.step) + span.u;
    combineColumns(low, middle, high, span.width, out);
  }
}

template <class Pixel>
void TiledMedian::filterSpan5(const Span& span)
{
  constexpr int kReach = 2;
  const cv::Rect whole(0, 0, image_.width, image_.height);
  const cv::Rect outer =
      whole & cv::Rect(span.u - kReach, span.v - kReach, span.width + 2 * kReach, span.height + 2 * kReach);
  sorted_.resize(static_cast<std::size_t>(outer.area()) * sizeof(Pixel));
  cv::Mat result(outer.height, outer.width, matType(image_), sorted_.data());
  cv::medianBlur(asMat(image_)(outer), result, 2 * kReach + 1);
  for (int v = span.v; v < span.v + span.height; ++v)
    std::copy_n(result.ptr<Pixel>(v - outer.y) + (span.u - outer.x), span.width,
                reinterpret_cast<Pixel*>(memory_.data() + static_cast<std::size_t>(v) * filtered_.step) + span.u);
}
}  // namespace weld_profiler
