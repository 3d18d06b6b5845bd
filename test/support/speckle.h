#pragma once

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

namespace weld_profiler
{
namespace test_support
{
/// What a speckle pattern is like.
struct SpeckleSettings
{
  int width = 0, height = 0;
  double contrast = 0.2;  ///< standard deviation over mean of the intensity, (0, 1]
  double grain_px = 2.0;  ///< full width at half maximum of the intensity's autocovariance
};

namespace speckle_details
{
/// Gaussian taps of unit energy, so that a field of unit white noise stays one of unit variance.
inline std::vector<double> kernelFor(double grain_px)
{
  // A field smoothed by a Gaussian of s has an intensity whose autocovariance is exp(-r^2 / (2 s^2)).
  const double s = grain_px / (2.0 * std::sqrt(2.0 * std::log(2.0)));
  const int reach = static_cast<int>(std::ceil(4.0 * s));
  std::vector<double> kernel;
  double energy = 0.0;
  for (int k = -reach; k <= reach; ++k)
  {
    kernel.push_back(std::exp(-0.5 * k * k / (s * s)));
    energy += kernel.back() * kernel.back();
  }
  for (double& tap : kernel)
    tap /= std::sqrt(energy);
  return kernel;
}

/// Adds weight times the square of a smoothed field of white noise.
inline void addSquareOfField(const SpeckleSettings& settings, const std::vector<double>& kernel, double weight,
                             std::mt19937& random, std::vector<double>& intensity)
{
  const auto taps = static_cast<int>(kernel.size());
  const int padded = settings.width + taps - 1;
  std::normal_distribution<double> normal;
  std::vector<double> field(static_cast<std::size_t>(padded) * static_cast<std::size_t>(settings.height + taps - 1));
  for (double& value : field)
    value = normal(random);
  std::vector<double> line(static_cast<std::size_t>(padded));
  for (int v = 0; v < settings.height; ++v)
  {
    std::fill(line.begin(), line.end(), 0.0);
    for (int j = 0; j < taps; ++j)
    {
      const double* row = field.data() + static_cast<std::ptrdiff_t>(v + j) * padded;
      for (int u = 0; u < padded; ++u)
        line[static_cast<std::size_t>(u)] += kernel[static_cast<std::size_t>(j)] * row[u];
    }
    double* out = intensity.data() + static_cast<std::ptrdiff_t>(v) * settings.width;
    for (int u = 0; u < settings.width; ++u)
    {
      const double value = std::inner_product(kernel.begin(), kernel.end(), line.begin() + u, 0.0);
      out[u] += weight * value * value;
    }
  }
}
}  // namespace speckle_details

/// Relative intensity of speckle, mean 1, row after row: the mean of 1 / contrast^2 independent patterns, each the
/// squared modulus of a complex Gaussian field (J. W. Goodman, "Speckle Phenomena in Optics", 2007, chapters 3 and 5).
inline std::vector<double> speckleIntensity(const SpeckleSettings& settings, std::mt19937& random)
{
  const std::vector<double> kernel = speckle_details::kernelFor(settings.grain_px);
  const int patterns = std::max(1, static_cast<int>(std::lround(1.0 / (settings.contrast * settings.contrast))));
  std::vector<double> intensity(static_cast<std::size_t>(settings.width) * static_cast<std::size_t>(settings.height));
  for (int i = 0; i < 2 * patterns; ++i)  // real and imaginary part
    speckle_details::addSquareOfField(settings, kernel, 0.5 / patterns, random, intensity);
  return intensity;
}
}  // namespace test_support
}  // namespace weld_profiler
