#include "simulation/speckle.h"

#include <cmath>

#include "simulation/random.h"

namespace weld_profiler
{
namespace simulation
{
namespace
{
constexpr int kSize = 1024;  // tile points a side, a power of two; repeats after 256 grains
constexpr double kPointsPerGrain = 4.0;
constexpr double kFwhmPerSigma = 2.3548200450309493;

/// Circular Gaussian blur along one axis.
std::vector<float> blurred(const std::vector<float>& from, double sigma, std::size_t point_step, std::size_t line_step)
{
  const int reach = static_cast<int>(std::ceil(4.0 * sigma));
  std::vector<float> kernel;
  for (int i = -reach; i <= reach; ++i)
    kernel.push_back(static_cast<float>(std::exp(-0.5 * i * i / (sigma * sigma))));
  const float* middle = kernel.data() + reach;
  std::vector<float> to(from.size(), 0.0F);
  const auto place = [&](int line, int i)
  { return static_cast<std::size_t>(line) * line_step + static_cast<std::size_t>(i & (kSize - 1)) * point_step; };
  for (int line = 0; line < kSize; ++line)
    for (int i = 0; i < kSize; ++i)
    {
      float sum = 0.0F;
      for (int k = -reach; k <= reach; ++k)
        sum += middle[k] * from[place(line, i + k)];
      to[place(line, i)] = sum;
    }
  return to;
}

/// Variance that bilinear reading takes from a field with this correlation between neighbours, averaged over all
/// places.
double bilinearLoss(double sigma)
{
  const double neighbour = std::exp(-0.25 / (sigma * sigma));
  const double axis = (2.0 + neighbour) / 3.0;
  return axis * axis;
}
}  // namespace

Speckle::Speckle(const SceneParams& scene, double x_metres_px, double y_metres_px)
{
  const double contrast = scene.speckle.contrast;
  if (contrast <= 0.0)
    return;
  // A Gaussian blur of sigma f gives an autocovariance of sigma sqrt(2) f, whose full width at half maximum is the
  // grain.
  const double sigma = kPointsPerGrain / (kFwhmPerSigma * std::sqrt(2.0));
  x_scale_ = kPointsPerGrain / (scene.speckle.grain_px * x_metres_px);
  y_scale_ = kPointsPerGrain / (scene.speckle.grain_px * y_metres_px);
  Random random(mix(scene.seed, 0x59EC41E));
  tile_.resize(static_cast<std::size_t>(kSize) * kSize);
  for (float& value : tile_)
    value = static_cast<float>(random.normal());
  tile_ = blurred(blurred(tile_, sigma, 1, kSize), sigma, kSize, 1);
  double power = 0.0;
  for (const float value : tile_)
    power += static_cast<double>(value) * value;
  const double wanted = std::log(1.0 + contrast * contrast);  // variance of the logarithm
  const double gain = std::sqrt(wanted / (power / tile_.size()) / bilinearLoss(sigma));
  for (float& value : tile_)
    value = static_cast<float>(std::exp(gain * value - 0.5 * wanted));
}

float Speckle::operator()(double x, double y) const
{
  constexpr double kShift = 1 << 24;  // keeps the index positive; a multiple of the tile's size
  const double column = x * x_scale_ + kShift;
  const double row = y * y_scale_ + kShift;
  const auto c = static_cast<int>(column);
  const auto r = static_cast<int>(row);
  const auto fc = static_cast<float>(column - c);
  const auto fr = static_cast<float>(row - r);
  const float* top = tile_.data() + static_cast<std::size_t>(r & (kSize - 1)) * kSize;
  const float* bottom = tile_.data() + static_cast<std::size_t>((r + 1) & (kSize - 1)) * kSize;
  const int left = c & (kSize - 1);
  const int right = (c + 1) & (kSize - 1);
  const float above = top[left] + fc * (top[right] - top[left]);
  const float below = bottom[left] + fc * (bottom[right] - bottom[left]);
  return above + fr * (below - above);
}
}  // namespace simulation
}  // namespace weld_profiler
