#include "simulation/sensor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "simulation/random.h"

namespace weld_profiler
{
namespace simulation
{
namespace
{
constexpr std::size_t kTile = 1U << 20;       // independent noise values; a row begins anywhere in them
constexpr double kFullScale = 255.0;          // [DN of 8 bit]
constexpr float kTo16Bit = 257.0F;            // 255 -> 65535
constexpr double kQuantisation = 1.0 / 12.0;  // variance of rounding [DN^2]

// A colour sensor at 650 nm: red, green, blue relative to red.
constexpr std::array<float, 3> kRedLight{ { 1.0F, 0.08F, 0.03F } };
constexpr std::array<float, 3> kWhiteLight{ { 1.0F, 1.0F, 1.0F } };
}  // namespace

Sensor::Sensor(const SceneParams& scene, int width, int height)
  : sensor_(scene.sensor), filter_(scene.light.filter), seed_(scene.seed), width_(width), height_(height)
{
  channels_ = sensor_.encoding == "bgr8" ? 3 : 1;
  bytes_ = sensor_.encoding == "mono16" ? 2 : 1;
  normal_.assign(kTile, 0.0F);
  if (sensor_.noise)
  {
    // (peak / snr)^2 = read^2 + rounding^2 + peak * variance_per_dn
    const double peak = std::min(scene.laser.peak, kFullScale);
    const double wanted = peak * peak / (sensor_.snr * sensor_.snr);
    variance_per_dn_ = (wanted - sensor_.read_noise * sensor_.read_noise - kQuantisation) / peak;
    Random random(mix(scene.seed, 0x5E4503));
    for (float& value : normal_)
      value = static_cast<float>(random.normal());
  }
  std::vector<float> values(kTile);
  const auto black = static_cast<float>(sensor_.black_level);
  const auto read = static_cast<float>(sensor_.read_noise);
  for (std::size_t i = 0; i < kTile; ++i)
    values[i] = black + read * normal_[i];
  dark_.resize(kTile * static_cast<std::size_t>(bytes_));
  encode(values.data(), kTile, dark_.data());
}

void Sensor::encode(const float* values, std::size_t count, std::uint8_t* to) const
{
  const float scale = bytes_ == 1 ? 1.0F : kTo16Bit;
  const float full = scale * static_cast<float>(kFullScale);
  for (std::size_t i = 0; i < count; ++i)
  {
    const float rounded = std::min(full, std::max(0.0F, values[i] * scale)) + 0.5F;  // positive: the cast cuts
    if (bytes_ == 1)
    {
      to[i] = static_cast<std::uint8_t>(rounded);
      continue;
    }
    const auto value = static_cast<std::uint16_t>(rounded);
    std::memcpy(to + 2 * i, &value, 2);
  }
}

void Sensor::dark(std::size_t offset, std::uint8_t* to) const
{
  std::memcpy(to, dark_.data() + offset * static_cast<std::size_t>(bytes_), step());
}

/// How a row's samples answer to the laser and to other light.
void Sensor::channel(int v, int index, std::vector<float>& laser_gain, std::vector<float>& other_gain) const
{
  int colour = 0;
  if (sensor_.encoding == "bayer_rggb8")
    colour = (v & 1) + (index & 1);  // R G / G B
  else if (sensor_.encoding == "bgr8")
    colour = 2 - index % 3;
  const auto c = static_cast<std::size_t>(colour);
  laser_gain[static_cast<std::size_t>(index)] = kRedLight[c];
  other_gain[static_cast<std::size_t>(index)] = filter_ ? kRedLight[c] : kWhiteLight[c];
}

void Sensor::lit(const Row& row, int v, std::size_t offset, std::uint8_t* to) const
{
  const std::size_t count = static_cast<std::size_t>(width_) * static_cast<std::size_t>(channels_);
  const auto channels = static_cast<std::size_t>(channels_);
  std::vector<float> signal(count, 0.0F);
  const bool colour = sensor_.encoding[0] == 'b';
  if (colour)
  {
    std::vector<float> laser(count), other(count);
    for (std::size_t i = 0; i < count; ++i)
    {
      channel(v, static_cast<int>(i), laser, other);
      signal[i] = (row.laser != nullptr ? laser[i] * row.laser[i / channels] : 0.0F) +
                  (row.background != nullptr ? other[i] * row.background[i / channels] : 0.0F);
    }
  }
  else
    for (const float* part : { row.laser, row.background })
      for (std::size_t i = 0; part != nullptr && i < count; ++i)
        signal[i] += part[i];
  if (sensor_.noise)
  {
    const auto read = static_cast<float>(sensor_.read_noise * sensor_.read_noise);
    const auto shot = static_cast<float>(variance_per_dn_);
    const float* normal = normal_.data() + offset;
    for (std::size_t i = 0; i < count; ++i)
      signal[i] += std::sqrt(read + shot * signal[i]) * normal[i];
  }
  for (float& value : signal)
    value += static_cast<float>(sensor_.black_level);
  encode(signal.data(), count, to);
}

void Sensor::develop(const StripeBand& band, bool swapped, const std::vector<float>& background, int frame,
                     std::vector<std::uint8_t>& pixels) const
{
  pixels.resize(step() * static_cast<std::size_t>(height_));
  std::vector<float> gathered(static_cast<std::size_t>(width_), 0.0F);
  Random random(mix(seed_, 0xF4A3E, static_cast<std::uint64_t>(frame)));
  const std::size_t places = kTile - static_cast<std::size_t>(width_) * static_cast<std::size_t>(channels_);
  for (int v = 0; v < height_; ++v)
  {
    Row row;
    if (swapped)
    {
      for (int u = band.first(); u < band.last(); ++u)
        gathered[static_cast<std::size_t>(u)] = band.row(u)[v];
      row.laser = gathered.data();
    }
    else if (v >= band.first() && v < band.last())
      row.laser = band.row(v);
    if (!background.empty())
      row.background = background.data() + static_cast<std::size_t>(v) * static_cast<std::size_t>(width_);
    std::uint8_t* to = pixels.data() + static_cast<std::size_t>(v) * step();
    const std::size_t offset = random.next() % places;
    if (row.laser == nullptr && row.background == nullptr)
      dark(offset, to);
    else
      lit(row, v, offset, to);
  }
}
}  // namespace simulation
}  // namespace weld_profiler
