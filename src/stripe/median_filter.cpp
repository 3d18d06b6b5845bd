#include "median_filter.h"

#include <opencv2/imgproc.hpp>

namespace weld_profiler
{
namespace
{
int matType(const ImageView& image)
{
  return image.bit_depth == 8 ? CV_8UC1 : CV_16UC1;
}

cv::Mat asMat(const ImageView& view)
{
  // cv::Mat knows no constant pixels; sources are only read.
  return { view.height, view.width, matType(view), const_cast<std::uint8_t*>(view.data), view.step };
}
}  // namespace

void medianFilter(const ImageView& image, int size, std::vector<std::uint8_t>& memory, ImageView& filtered)
{
  filtered = image;
  filtered.step = static_cast<std::size_t>(image.width) * (image.bit_depth == 8 ? 1 : 2);
  memory.resize(filtered.step * static_cast<std::size_t>(image.height));
  filtered.data = memory.data();
  cv::Mat result = asMat(filtered);
  if (size == 0)
    asMat(image).copyTo(result);
  else
    cv::medianBlur(asMat(image), result, size);
}
}  // namespace weld_profiler
