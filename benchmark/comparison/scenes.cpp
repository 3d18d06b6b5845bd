#include "comparison/scenes.h"

#include <cmath>
#include <stdexcept>

#include "comparison/ghosts.h"

namespace weld_profiler
{
namespace comparison
{
using test_support::StripePicture;

namespace
{
constexpr double kPi = 3.14159265358979323846;
constexpr int kMargin = 12;         ///< columns at the ends of a scene that are not judged
constexpr double kSoftEnd = 1.5;    ///< of a stripe that fades, 1-sigma [px]
constexpr int kLongestRepair = 20;  ///< StripeParams::max_gap_px
/// Camera of the scenes whose noise does not follow from an SNR: 2 DN read noise, 25 electrons a grey level.
constexpr double kReadNoise = 2.0, kShotGain = 0.04;

Sample plain(const StripePicture& scene)
{
  return sampleOf(scene, kMargin);
}

Sample reflectance(unsigned seed)
{
  StripePicture scene = straightScene(2.0, 45.0, seed);
  scene.peak = 150.0;
  scene.snr = 50.0;
  scene.gain = [](double u) { return 1.0 + 0.4 * std::sin(2.0 * kPi * u / 20.0); };
  return sampleOf(scene, 30);
}

Sample speckle(unsigned seed)
{
  StripePicture scene = beadScene(50.0, seed);
  scene.peak = 130.0;
  scene.speckle = 0.2;
  scene.grain_px = 2.0;
  return plain(scene);
}

Sample saturated(double peak, unsigned seed)
{
  StripePicture scene = straightScene(2.0, 15.0, seed);
  scene.peak = peak;
  scene.read_noise = kReadNoise;
  scene.shot_gain = kShotGain;
  return sampleOf(scene, 30);
}

/// Breaks of 5, 10, 15 columns, which may be filled, and of 40, which is to stay open.
Sample gaps(unsigned seed)
{
  return brokenBead({ { 60, 5 }, { 145, 10 }, { 230, 15 }, { 315, 40 } }, seed);
}

/// A stripe that fades out and in again over a few pixels, which draws column methods along it on a flank.
Sample fading(unsigned seed)
{
  StripePicture scene = beadScene(50.0, seed);
  const auto inside = [](double u) { return 20.0 - std::abs(std::fmod(u, 100.0) - 60.0); };
  scene.gain = [inside](double u) { return 0.5 * std::erfc(inside(u) / (kSoftEnd * std::sqrt(2.0))); };
  Sample sample = plain(scene);
  for (int u = 0; u < scene.width; ++u)
    if (inside(u) > 0.0)
      sample.expected[static_cast<std::size_t>(u)] = inside(u) > 5.0 * kSoftEnd ? Expected::Nothing : Expected::Beyond;
  return sample;
}

/// A jump of 30 px, half of the time with a break of 10 columns in it, which must not be bridged.
Sample step(unsigned seed)
{
  constexpr double kAt = 199.5;
  StripePicture scene;
  scene.width = 400;
  scene.height = 160;
  scene.snr = 50.0;
  scene.seed = seed;
  const double row = 60.0 + 0.137 * seed;
  scene.row = [=](double u) { return row + 0.021 * u + (u > kAt ? 30.0 : 0.0); };
  scene.slope = [](double) { return 0.021; };
  const double half = seed % 2 == 0 ? 5.0 : 0.0;
  scene.gain = [=](double u) { return std::abs(u - kAt) < half ? 0.0 : 1.0; };
  Sample sample = plain(scene);
  for (int u = 0; u < scene.width; ++u)
    if (std::abs(u - kAt) < half)
      sample.expected[static_cast<std::size_t>(u)] = Expected::Nothing;
  return sample;
}

/// Every width from 1.2 to 8 px in one image.
Sample widths(unsigned seed)
{
  StripePicture scene = straightScene(8.0, 10.0, seed);
  scene.width = 1000;
  scene.height = 460;
  scene.sigma = 2.0;
  scene.snr = 50.0;
  scene.sigma_at = [](double u) { return 1.2 * std::pow(8.0 / 1.2, u / 1000.0); };
  return sampleOf(scene, 30);
}

Sample flatTopped(unsigned seed)
{
  StripePicture scene = straightScene(2.5, 15.0, seed);
  scene.snr = 50.0;
  scene.profile = [](double d) { return std::exp(-0.5 * std::pow(d / 3.0, 4.0)); };
  return sampleOf(scene, 30);
}

Sample skewed(unsigned seed)
{
  StripePicture scene = straightScene(2.5, 15.0, seed);
  scene.snr = 50.0;
  scene.profile = [](double d) { return std::exp(-0.5 * std::pow(d / (d < 0.0 ? 1.5 : 2.5), 2.0)); };
  return sampleOf(scene, 30);
}

Sample dim(unsigned seed)
{
  StripePicture scene = straightScene(2.0, 15.0, seed);
  scene.peak = 20.0;
  scene.snr = 10.0;
  return sampleOf(scene, 30);
}

using Maker = Sample (*)(unsigned seed);

struct Entry
{
  const char* name;
  int seeds;
  Maker make;
};

const Entry kScenes[] = {
  { "bead_noise_free", 6, [](unsigned seed) { return plain(beadScene(0.0, seed)); } },
  { "bead", 24, [](unsigned seed) { return plain(beadScene(50.0, seed)); } },
  { "reflectance", 24, reflectance },
  { "speckle", 24, speckle },
  { "peak_300", 24, [](unsigned seed) { return saturated(300.0, seed); } },
  { "peak_500", 24, [](unsigned seed) { return saturated(500.0, seed); } },
  { "peak_1000", 24, [](unsigned seed) { return saturated(1000.0, seed); } },
  { "ghosts", 12, ghostSample },
  { "gaps", 24, gaps },
  { "fading_ends", 24, fading },
  { "step", 24, step },
  { "widths_1.2_to_8", 12, widths },
  { "flat_topped", 24, flatTopped },
  { "skewed", 24, skewed },
  { "dim", 24, dim },
};
}  // namespace

StripePicture straightScene(double sigma, double degrees, unsigned seed)
{
  const double slope = std::tan(degrees * kDegree);
  const double margin = 20.0 + 8.0 * sigma * std::sqrt(1.0 + slope * slope);
  StripePicture scene = test_support::straight(degrees, margin + 0.1237 * seed);
  scene.width = 360;
  scene.height = static_cast<int>(std::abs(slope) * scene.width + 2.0 * margin) + 1;
  scene.sigma = sigma;
  scene.seed = 1000 + seed;
  return scene;
}

StripePicture beadScene(double snr, unsigned seed)
{
  constexpr double kPeriod = 210.0;  // of a sine with slope 1 and curvature 2 pi / 210 = 0.03 / px
  StripePicture scene;
  scene.width = 400;
  scene.height = 160;
  scene.snr = snr;
  scene.seed = 2000 + seed;
  const double shift = 17.3 * seed, row = 80.0 + 0.137 * seed;
  scene.row = [=](double u) { return row + kPeriod / (2.0 * kPi) * std::sin(2.0 * kPi * (u + shift) / kPeriod); };
  scene.slope = [=](double u) { return std::cos(2.0 * kPi * (u + shift) / kPeriod); };
  return scene;
}

Sample brokenBead(const std::vector<Break>& breaks, unsigned seed)
{
  const StripePicture scene = beadScene(50.0, seed);
  std::vector<double> light = lightOf(scene);
  std::vector<Expected> expected;
  for (int u = 0; u < scene.width; ++u)
  {
    const bool end = u < kMargin || u >= scene.width - kMargin;
    expected.push_back(end ? Expected::Beyond : Expected::Centre);
    for (const Break& dark : breaks)
      if (u >= dark.first && u < dark.first + dark.length)
      {
        expected.back() = dark.length > kLongestRepair ? Expected::Nothing : Expected::Optional;
        for (int v = 0; v < scene.height; ++v)
          light[static_cast<std::size_t>(v) * static_cast<std::size_t>(scene.width) + static_cast<std::size_t>(u)] = 0;
      }
  }
  return Sample{ scene, render(scene, light), expected };
}

std::vector<std::string> sceneNames()
{
  std::vector<std::string> names;
  for (const Entry& entry : kScenes)
    names.emplace_back(entry.name);
  return names;
}

SceneSet makeScene(const std::string& name, int seeds)
{
  for (const Entry& entry : kScenes)
    if (name == entry.name)
    {
      SceneSet scene;
      scene.name = name;
      const int count = std::max(2, entry.seeds * seeds / 24);
      for (int seed = 1; seed <= count; ++seed)
        scene.samples.push_back(entry.make(static_cast<unsigned>(seed)));
      scene.stripe_sigma = scene.samples.front().truth.sigma;
      scene.noise = scene.samples.front().truth.snr > 0.0 || scene.samples.front().truth.read_noise > 0.0;
      scene.centre_defined = name != "skewed";
      return scene;
    }
  throw std::invalid_argument("there is no scene '" + name + "'");
}
}  // namespace comparison
}  // namespace weld_profiler
