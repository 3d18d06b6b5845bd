#include "direction.h"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>

#include "normal_angle.h"

namespace weld_profiler
{
void transpose(const ImageView& image, std::vector<std::uint8_t>& memory, ImageView& transposed)
{
  const int type = image.bit_depth == 8 ? CV_8UC1 : CV_16UC1;
  transposed = image;
  transposed.width = image.height;
  transposed.height = image.width;
  transposed.step = static_cast<std::size_t>(image.height) * static_cast<std::size_t>(image.bit_depth / 8);
  memory.resize(transposed.step * static_cast<std::size_t>(image.width));
  transposed.data = memory.data();
  const cv::Mat source(image.height, image.width, type, const_cast<std::uint8_t*>(image.data), image.step);
  cv::Mat result(transposed.height, transposed.width, type, memory.data(), transposed.step);
  cv::transpose(source, result);
}

void transpose(Stripe& stripe)
{
  stripe.direction = stripe.direction == Direction::AlongU ? Direction::AlongV : Direction::AlongU;
  stripe.u.swap(stripe.v);
  const double quarter_turn = 0.5 * std::acos(-1.0);
  for (float& angle : stripe.normal_angle)
    angle = normalAngle(quarter_turn - angle);  // (cos a, sin a) becomes (sin a, cos a)
}

double lengthAlong(const Stripe& stripe)
{
  double length = 0.0;
  // The normal of a stripe along the rows points along the columns.
  for (const float angle : stripe.normal_angle)
    length += std::abs(stripe.direction == Direction::AlongU ? std::sin(angle) : std::cos(angle));
  return length;
}
}  // namespace weld_profiler
