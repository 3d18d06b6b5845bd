#include "support/render_stripe.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace weld_profiler
{
namespace test_support
{
namespace
{
double slopeAt(const StripePicture& stripe, double u)
{
  constexpr double kStep = 1e-3;
  return stripe.slope ? stripe.slope(u) : (stripe.row(u + kStep) - stripe.row(u - kStep)) / (2.0 * kStep);
}

/// Column of the foot of the perpendicular from (u, v).
double footOf(const StripePicture& stripe, double u, double v)
{
  double foot = u;
  for (int i = 0; i < 12; ++i)
  {
    const double slope = slopeAt(stripe, foot);
    foot += 0.7 * ((u - foot) + slope * (v - stripe.row(foot))) / (1.0 + slope * slope);
  }
  return foot;
}
}  // namespace

ImageView Picture::view() const
{
  ImageView view;
  view.data = bytes.data();
  view.width = width;
  view.height = height;
  view.step = static_cast<std::size_t>(width) * static_cast<std::size_t>(bit_depth / 8);
  view.bit_depth = bit_depth;
  return view;
}

RawImage Picture::raw() const
{
  const std::uint16_t probe = 1;
  std::uint8_t first = 0;
  std::memcpy(&first, &probe, 1);
  RawImage image;
  image.data = bytes.data();
  image.width = width;
  image.height = height;
  image.step = view().step;
  image.encoding = bit_depth == 8 ? "mono8" : "mono16";
  image.big_endian = first == 0;
  return image;
}

double Picture::at(int u, int v) const
{
  return bit_depth == 8 ? view().row<std::uint8_t>(v)[u] : view().row<std::uint16_t>(v)[u];
}

void Picture::set(int u, int v, double value)
{
  const std::size_t index = static_cast<std::size_t>(v) * static_cast<std::size_t>(width) + static_cast<std::size_t>(u);
  if (bit_depth == 8)
  {
    bytes[index] = static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
    return;
  }
  const auto level = static_cast<std::uint16_t>(std::lround(std::clamp(value, 0.0, 65535.0)));
  std::memcpy(bytes.data() + 2 * index, &level, 2);
}

Picture blank(int width, int height, double value, int bit_depth)
{
  Picture picture;
  picture.width = width;
  picture.height = height;
  picture.bit_depth = bit_depth;
  picture.bytes.assign(
      static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * static_cast<std::size_t>(bit_depth / 8), 0);
  for (int v = 0; v < height; ++v)
    for (int u = 0; u < width; ++u)
      picture.set(u, v, value);
  return picture;
}

Picture render(const StripePicture& stripe)
{
  std::mt19937 random(stripe.seed);
  std::normal_distribution<double> normal;
  // Speckle: the intensity of a complex field of blobs of about two pixels, here as noise smoothed over 3x3 pixels.
  std::vector<double> grain;
  const int padded = stripe.width + 2;
  if (stripe.speckle > 0.0)
  {
    grain.resize(static_cast<std::size_t>(padded) * static_cast<std::size_t>(stripe.height + 2));
    for (double& value : grain)
      value = normal(random);
  }
  const double variance = stripe.snr > 0.0 ? std::pow(stripe.peak / stripe.snr, 2.0) : 0.0;
  Picture picture = blank(stripe.width, stripe.height, 0.0, stripe.bit_depth);
  for (int v = 0; v < stripe.height; ++v)
    for (int u = 0; u < stripe.width; ++u)
    {
      double light = 0.0;
      const double reach = 6.0 * stripe.sigma * std::sqrt(1.0 + std::pow(slopeAt(stripe, u), 2.0)) + 4.0;
      if (std::abs(v - stripe.row(u)) < reach)
      {
        const double foot = footOf(stripe, u, v);
        const double square = std::pow(u - foot, 2.0) + std::pow(v - stripe.row(foot), 2.0);
        light = stripe.peak * std::exp(-0.5 * square / (stripe.sigma * stripe.sigma));
        if (stripe.gain)
          light *= stripe.gain(foot);
        if (stripe.speckle > 0.0)
        {
          double sum = 0.0;
          for (int j = 0; j < 3; ++j)
            for (int i = 0; i < 3; ++i)
              sum += grain[static_cast<std::size_t>((v + j) * padded + u + i)] / 3.0;
          light *= std::max(0.0, 1.0 + stripe.speckle * sum);
        }
      }
      double value = stripe.background + light + (stripe.ambient ? stripe.ambient(u, v) : 0.0);
      if (variance > 0.0)
        value += normal(random) * std::sqrt(0.5 * variance + 0.5 * variance * light / stripe.peak);
      const double scale = stripe.bit_depth == 8 ? 1.0 : 257.0;
      picture.set(u, v, std::min(value, stripe.clip) * scale);
    }
  return picture;
}

Picture transposed(const Picture& picture)
{
  Picture turned = blank(picture.height, picture.width, 0.0, picture.bit_depth);
  for (int v = 0; v < picture.height; ++v)
    for (int u = 0; u < picture.width; ++u)
      turned.set(v, u, picture.at(u, v));
  return turned;
}

StripePicture straight(double degrees, double row_at_zero)
{
  const double slope = std::tan(degrees * std::acos(-1.0) / 180.0);
  StripePicture stripe;
  stripe.row = [slope, row_at_zero](double u) { return row_at_zero + slope * u; };
  stripe.slope = [slope](double) { return slope; };
  return stripe;
}

double distanceAcross(const StripePicture& stripe, double u, double v)
{
  const double foot = footOf(stripe, u, v);
  const double distance = std::hypot(u - foot, v - stripe.row(foot));
  return v < stripe.row(u) ? -distance : distance;
}
}  // namespace test_support
}  // namespace weld_profiler
