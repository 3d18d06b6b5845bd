#include "comparison/ghosts.h"

#include <cmath>
#include <random>

namespace weld_profiler
{
namespace comparison
{
using test_support::StripePicture;

namespace
{
constexpr double kPi = 3.14159265358979323846;
constexpr int kSpatters = 60;
constexpr double kClear = 3.0;  ///< sigmas between the stripe and the edge of a spatter

void addGlow(const StripePicture& scene, std::vector<double>& light)
{
  // Half maximum over a tenth of the frame.
  const double radius = std::sqrt(0.1 * scene.width * scene.height / kPi);
  const double sigma = radius / std::sqrt(2.0 * std::log(2.0));
  const double u0 = 0.45 * scene.width, v0 = scene.row(u0) - 60.0;
  std::size_t index = 0;
  for (int v = 0; v < scene.height; ++v)
    for (int u = 0; u < scene.width; ++u, ++index)
      light[index] += 50.0 * std::exp(-0.5 * (std::pow(u - u0, 2.0) + std::pow(v - v0, 2.0)) / (sigma * sigma));
}

void addSpatter(const StripePicture& scene, bool near, std::mt19937& random, std::vector<double>& light)
{
  std::uniform_real_distribution<double> unit;
  const double radius = 1.0 + 4.0 * unit(random), peak = 120.0 + 200.0 * unit(random);
  double u0 = 0.0, v0 = 0.0;
  do
  {
    u0 = unit(random) * scene.width;
    v0 = near ? scene.row(u0) + 160.0 * (unit(random) - 0.5) : unit(random) * scene.height;
  } while (std::abs(distanceAcross(scene, u0, v0)) < kClear * scene.sigma + radius + 2.0);
  for (int v = std::max(0, static_cast<int>(v0 - 12.0)); v < std::min(scene.height, static_cast<int>(v0 + 13.0)); ++v)
    for (int u = std::max(0, static_cast<int>(u0 - 12.0)); u < std::min(scene.width, static_cast<int>(u0 + 13.0)); ++u)
    {
      // A disc with the softness of the optics.
      const double edge = std::hypot(u - u0, v - v0) - radius;
      light[static_cast<std::size_t>(v) * static_cast<std::size_t>(scene.width) + static_cast<std::size_t>(u)] +=
          peak / (1.0 + std::exp(2.0 * edge));
    }
}
}  // namespace

StripePicture weldScene(int width, int height)
{
  StripePicture scene;
  scene.width = width;
  scene.height = height;
  scene.snr = 50.0;
  const double scale = width / 1440.0, middle = 0.55 * height;
  // A bead of 60 rows on two plates, flanks of 45 deg at their steepest.
  scene.row = [=](double u)
  {
    const double x = (u / scale - 720.0) / 90.0;
    return middle + 0.03 * (u - 0.5 * width) - scale * 60.0 / (1.0 + std::pow(x, 6.0));
  };
  return scene;
}

static StripePicture secondReflection(const StripePicture& scene, unsigned seed)
{
  StripePicture second = scene;
  second.sigma = 1.8;
  const double phase = 1.7 * seed, side = seed % 2 == 0 ? -1.0 : 1.0;
  const auto row = scene.row;
  second.row = [=](double u) { return row(u) + side * (42.5 + 17.0 * std::sin(2.0 * kPi * u / 900.0 + phase)); };
  // There over six tenths of the length, brighter than the stripe over a third.
  second.gain = [=](double u) { return std::max(0.0, 0.35 + 1.15 * std::sin(2.0 * kPi * u / 410.0 + 2.0 * phase)); };
  return second;
}

Sample ghostSample(unsigned seed)
{
  StripePicture scene = weldScene(1440, 1080);
  scene.peak = 120.0;
  scene.seed = 3000 + seed;
  scene.more_light = lightOf(secondReflection(scene, seed));
  addGlow(scene, scene.more_light);
  std::mt19937 random(scene.seed);
  for (int i = 0; i < kSpatters; ++i)
    addSpatter(scene, i % 2 == 0, random, scene.more_light);
  Sample sample = sampleOf(scene);
  sample.truth.more_light.clear();
  return sample;
}
}  // namespace comparison
}  // namespace weld_profiler
