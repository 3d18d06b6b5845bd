#include "direction.h"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>

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
  const float half_turn = static_cast<float>(std::acos(-1.0));
  for (float& angle : stripe.normal_angle)
  {
    angle = 0.5F * half_turn - angle;  // (cos a, sin a) becomes (sin a, cos a)
    if (angle > 0.5F * half_turn)
      angle -= half_turn;
  }
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
