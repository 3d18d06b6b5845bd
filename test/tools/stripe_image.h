#pragma once

#include <cmath>
#include <string>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

namespace weld_profiler
{
/// Writes an image of a stripe along the rows: a Gaussian of sigma 2 px about row `v`, rising by `slope` a column.
inline void writeStripeImage(const std::string& path, double v, double slope = 0.0, cv::Size size = { 320, 240 })
{
  cv::Mat image(size, CV_8UC1);
  for (int row = 0; row < size.height; ++row)
    for (int column = 0; column < size.width; ++column)
    {
      const double across = row - (v + slope * column);
      image.at<unsigned char>(row, column) =
          cv::saturate_cast<unsigned char>(5.0 + 180.0 * std::exp(-across * across / 8.0));
    }
  cv::imwrite(path, image);
}
}  // namespace weld_profiler
