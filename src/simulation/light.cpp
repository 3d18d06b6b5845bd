#include "simulation/light.h"

#include <algorithm>
#include <cmath>

#include "simulation/random.h"

namespace weld_profiler
{
namespace simulation
{
namespace
{
// The arc burns beyond the far edge of the field; its glow lies over the picture.
constexpr double kArcU = 0.62;        // of the width
constexpr double kArcV = -0.06;       // of the height
constexpr double kArcRadius = 0.25;   // of the width
constexpr double kFlashRadius = 0.7;  // of the width
constexpr double kFlicker = 0.3;      // of the arc from frame to frame
constexpr double kVignette = 0.25;    // loss of room light in the corners
constexpr double kSparkPeak = 350.0;  // brightest [DN behind the filter]
}  // namespace

Light::Light(const SceneParams& scene, int width, int height)
  : light_(scene.light), seed_(scene.seed), width_(width), height_(height)
{
}

bool Light::flashes(int frame) const
{
  return Random(mix(seed_, 0xF1A54, static_cast<std::uint64_t>(frame))).uniform() < light_.flash_share;
}

std::vector<float> Light::field(int frame) const
{
  std::vector<float> field;
  const bool flash = flashes(frame);
  if (light_.ambient <= 0.0 && light_.arc <= 0.0 && light_.sparks == 0 && !flash)
    return field;
  field.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), 0.0F);
  if (light_.ambient > 0.0)
    addRoom(field);
  Random random(mix(seed_, 0xA4C, static_cast<std::uint64_t>(frame)));
  const double flicker = random.uniform(1.0 - kFlicker, 1.0 + kFlicker);
  const double arc_share = transmission(light_.arc_transmission);
  if (light_.arc > 0.0)
    addSpot(Spot{ light_.arc * arc_share * flicker, kArcU * width_, kArcV * height_, kArcRadius * width_ }, field);
  if (flash)
    addSpot(Spot{ light_.flash * arc_share * flicker, kArcU * width_, kArcV * height_, kFlashRadius * width_ }, field);
  addSparks(frame, field);
  return field;
}

void Light::addRoom(std::vector<float>& field) const
{
  const double level = light_.ambient * transmission(light_.ambient_transmission);
  const double half_width = 0.5 * width_;
  const double half_height = 0.5 * height_;
  const double corner = half_width * half_width + half_height * half_height;
  for (int v = 0; v < height_; ++v)
  {
    const auto rows = static_cast<float>((v - half_height) * (v - half_height));
    float* to = field.data() + static_cast<std::size_t>(v) * static_cast<std::size_t>(width_);
    for (int u = 0; u < width_; ++u)
    {
      const auto off = static_cast<float>(u - half_width);
      to[u] += static_cast<float>(level) * (1.0F - static_cast<float>(kVignette / corner) * (rows + off * off));
    }
  }
}

void Light::addSpot(const Spot& spot, std::vector<float>& field) const
{
  const auto scale = static_cast<float>(1.0 / (spot.radius * spot.radius));
  const auto level = static_cast<float>(spot.level);
  for (int v = 0; v < height_; ++v)
  {
    const auto rows = 1.0F + scale * static_cast<float>((v - spot.v) * (v - spot.v));
    float* to = field.data() + static_cast<std::size_t>(v) * static_cast<std::size_t>(width_);
    for (int u = 0; u < width_; ++u)
    {
      const auto off = static_cast<float>(u - spot.u);
      to[u] += level / (rows + scale * off * off);
    }
  }
}

void Light::addSparks(int frame, std::vector<float>& field) const
{
  Random random(mix(seed_, 0x59A4C, static_cast<std::uint64_t>(frame)));
  for (int i = 0; i < light_.sparks; ++i)
  {
    double u = random.uniform(0.0, width_);
    double v = random.uniform(0.0, height_);
    const double angle = random.uniform(0.0, 6.283185307179586);
    const double length = random.uniform(0.0, 16.0);
    const double sigma = random.uniform(0.7, 1.6);
    const double peak = kSparkPeak * random.uniform(0.1, 1.0);
    for (double along = 0.0; along <= length; along += 1.0, u += std::cos(angle), v += std::sin(angle))
      for (int row = static_cast<int>(v - 3 * sigma); row <= static_cast<int>(v + 3 * sigma); ++row)
        for (int column = static_cast<int>(u - 3 * sigma); column <= static_cast<int>(u + 3 * sigma); ++column)
        {
          if (row < 0 || row >= height_ || column < 0 || column >= width_)
            continue;
          const double squared = (column - u) * (column - u) + (row - v) * (row - v);
          float& pixel = field[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) + column];
          pixel = std::max(pixel, static_cast<float>(peak * std::exp(-0.5 * squared / (sigma * sigma))));
        }
  }
}
}  // namespace simulation
}  // namespace weld_profiler
