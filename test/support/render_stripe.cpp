#include "support/render_stripe.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>

#include "support/speckle.h"

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
double footOf(const StripePicture& stripe, double u, double v, double start)
{
  double foot = start;
  for (int i = 0; i < 12; ++i)
  {
    const double slope = slopeAt(stripe, foot);
    foot += 0.7 * ((u - foot) + slope * (v - stripe.row(foot))) / (1.0 + slope * slope);
  }
  return foot;
}

double sigmaAt(const StripePicture& stripe, double u)
{
  return stripe.sigma_at ? stripe.sigma_at(u) : stripe.sigma;
}

/// Rows of the centre line at whole columns, beyond the image's edges too: where to begin the search of a foot.
class LineTable
{
public:
  LineTable(const StripePicture& stripe, int beyond) : beyond_(beyond)
  {
    for (int u = -beyond; u < stripe.width + beyond; ++u)
      rows_.push_back(stripe.row(u));
  }
  double nearest(int u, int v) const
  {
    const double own = at(u) - v;
    int best = 0;
    double least = own * own;
    const int reach = std::min(beyond_, static_cast<int>(std::abs(own)) + 1);
    for (int k = -reach; k <= reach; ++k)
    {
      const double square = std::pow(at(u + k) - v, 2.0) + static_cast<double>(k) * k;
      if (square < least)
      {
        least = square;
        best = k;
      }
    }
    return u + best;
  }

private:
  double at(int u) const
  {
    return rows_[std::min(static_cast<std::size_t>(std::max(0, u + beyond_)), rows_.size() - 1)];
  }
  int beyond_;
  std::vector<double> rows_;
};

/// Relative brightness of the pixels, row after row; empty without speckle.
std::vector<double> speckleOf(const StripePicture& stripe, std::mt19937& random)
{
  if (!(stripe.speckle > 0.0))
    return {};
  if (stripe.grain_px > 0.0)
    return speckleIntensity(SpeckleSettings{ stripe.width, stripe.height, stripe.speckle, stripe.grain_px }, random);
  std::normal_distribution<double> normal;
  const int padded = stripe.width + 2;
  std::vector<double> grain(static_cast<std::size_t>(padded) * static_cast<std::size_t>(stripe.height + 2));
  for (double& value : grain)
    value = normal(random);
  std::vector<double> brightness;
  for (int v = 0; v < stripe.height; ++v)
    for (int u = 0; u < stripe.width; ++u)
    {
      double sum = 0.0;
      for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i)
          sum += grain[static_cast<std::size_t>(v + j) * static_cast<std::size_t>(padded) +
                       static_cast<std::size_t>(u + i)] /
                 3.0;
      brightness.push_back(std::max(0.0, 1.0 + stripe.speckle * sum));
    }
  return brightness;
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

std::vector<double> lightOf(const StripePicture& stripe)
{
  std::vector<double> light(static_cast<std::size_t>(stripe.width) * static_cast<std::size_t>(stripe.height), 0.0);
  const LineTable table(stripe, 64);
  for (int u = 0; u < stripe.width; ++u)
  {
    const double middle = stripe.row(u);
    const double reach = 6.0 * sigmaAt(stripe, u) * std::sqrt(1.0 + std::pow(slopeAt(stripe, u), 2.0)) + 4.0;
    const int first = static_cast<int>(std::clamp(std::ceil(middle - reach), 0.0, static_cast<double>(stripe.height)));
    const int last = static_cast<int>(std::clamp(std::floor(middle + reach), -1.0, stripe.height - 1.0));
    for (int v = first; v <= last; ++v)
    {
      const double foot = footOf(stripe, u, v, table.nearest(u, v));
      const double square = std::pow(u - foot, 2.0) + std::pow(v - stripe.row(foot), 2.0);
      const double sigma = sigmaAt(stripe, foot);
      const double side = v < stripe.row(foot) ? -1.0 : 1.0;
      const double shape =
          stripe.profile ? stripe.profile(side * std::sqrt(square)) : std::exp(-0.5 * square / (sigma * sigma));
      light[static_cast<std::size_t>(v) * static_cast<std::size_t>(stripe.width) + static_cast<std::size_t>(u)] =
          stripe.peak * shape * (stripe.gain ? stripe.gain(foot) : 1.0);
    }
  }
  return light;
}

Picture render(const StripePicture& stripe)
{
  return render(stripe, lightOf(stripe));
}

Picture render(const StripePicture& stripe, const std::vector<double>& own)
{
  std::mt19937 random(stripe.seed);
  std::normal_distribution<double> normal;
  const std::vector<double> speckle = speckleOf(stripe, random);
  const bool physical = stripe.read_noise > 0.0;
  const double variance = stripe.snr > 0.0 ? std::pow(stripe.peak / stripe.snr, 2.0) : 0.0;
  const double read = physical ? stripe.read_noise * stripe.read_noise : 0.5 * variance;
  const double shot = physical ? stripe.shot_gain : 0.5 * variance / stripe.peak;
  const double scale = stripe.bit_depth == 8 ? 1.0 : 257.0;
  Picture picture = blank(stripe.width, stripe.height, 0.0, stripe.bit_depth);
  std::size_t index = 0;
  for (int v = 0; v < stripe.height; ++v)
    for (int u = 0; u < stripe.width; ++u, ++index)
    {
      double light = own[index];
      if (!speckle.empty())
        light *= speckle[index];
      if (!stripe.more_light.empty())
        light += stripe.more_light[index];
      double value = stripe.background + light + (stripe.ambient ? stripe.ambient(u, v) : 0.0);
      if (read > 0.0)
        value += normal(random) * std::sqrt(read + shot * light);
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
  const double foot = footOf(stripe, u, v, u);
  const double distance = std::hypot(u - foot, v - stripe.row(foot));
  return v < stripe.row(u) ? -distance : distance;
}
}  // namespace test_support
}  // namespace weld_profiler
