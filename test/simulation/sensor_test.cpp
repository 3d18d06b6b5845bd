#include <cmath>
#include <thread>

#include <gtest/gtest.h>

#include "simulation/scenes.h"

namespace weld_profiler
{
namespace
{
struct Spread
{
  double mean = 0.0, sigma = 0.0;
};

Spread spread(const std::vector<double>& values)
{
  Spread result;
  for (const double value : values)
    result.mean += value / values.size();
  for (const double value : values)
    result.sigma += (value - result.mean) * (value - result.mean) / values.size();
  result.sigma = std::sqrt(result.sigma);
  return result;
}

SceneParams noisyFlat()
{
  SceneParams scene = flatScene();
  scene.sensor.encoding = "mono8";
  scene.sensor.noise = true;
  return scene;
}

std::vector<double> rowOf(const SimulatedScan& scan, int frames, int v)
{
  std::vector<double> values;
  for (int frame = 0; frame < frames; ++frame)
  {
    const auto pixels = frameOf(scan, frame);
    const auto first = pixels.begin() + static_cast<std::ptrdiff_t>(v) * scan.width();
    values.insert(values.end(), first, first + scan.width());
  }
  return values;
}

TEST(Sensor, HasTheAskedSignalToNoiseAtThePeak)
{
  for (const double snr : { 20.0, 50.0 })
  {
    SceneParams scene = noisyFlat();
    scene.sensor.snr = snr;
    const SimulatedScan scan(scene);
    const Spread peak = spread(rowOf(scan, 4, 540));  // 5760 pixels: sigma within 1 %
    EXPECT_NEAR(peak.mean, 180.0, 0.5);
    EXPECT_NEAR(peak.mean / peak.sigma, snr, 0.03 * snr);
  }
}

TEST(Sensor, HasShotNoiseThatGrowsWithTheRootOfTheSignal)
{
  const SimulatedScan scan(noisyFlat());
  const double rounding = 1.0 / 12.0;
  const double read = 1.2 * 1.2;
  const double shot = (3.6 * 3.6 - read - rounding) / 180.0;  // variance a DN
  const Spread dark = spread(rowOf(scan, 4, 300));
  EXPECT_NEAR(dark.mean, 0.0, 0.05);
  EXPECT_NEAR(dark.sigma, std::sqrt(read + rounding), 0.03);
  const Spread flank = spread(rowOf(scan, 4, 542));
  EXPECT_NEAR(flank.sigma, std::sqrt(read + rounding + shot * 180.0 * std::exp(-0.5)), 0.1);
}

TEST(Sensor, HasNoiseThatNeighboursDoNotShare)
{
  const SimulatedScan scan(noisyFlat());
  const auto a = rowOf(scan, 1, 300);
  const auto b = rowOf(scan, 1, 301);
  double beside = 0.0, below = 0.0, all = 0.0;
  for (std::size_t i = 0; i + 1 < a.size(); ++i)
  {
    beside += a[i] * a[i + 1];
    below += a[i] * b[i];
    all += a[i] * a[i];
  }
  EXPECT_LT(std::abs(beside / all), 0.1);
  EXPECT_LT(std::abs(below / all), 0.1);
}

TEST(Sensor, ClipsWhatIsTooBright)
{
  SceneParams scene = noisyFlat();
  scene.laser.peak = 1000.0;
  const SimulatedScan scan(scene);
  std::vector<std::uint8_t> pixels;
  scan.render(0, pixels);
  for (int u = 0; u < scan.width(); ++u)
    ASSERT_EQ(pixels[540U * 1440U + static_cast<std::size_t>(u)], 255);
}

TEST(Sensor, GivesTheSameBytesForTheSameSeedAndOthersForAnother)
{
  for (const char* preset : { "realistic", "harsh" })
  {
    SceneParams scene = scenePreset(preset);
    std::vector<std::uint8_t> first, again, other;
    SimulatedScan(scene).render(7, first);
    SimulatedScan(scene).render(7, again);
    scene.seed = 2;
    SimulatedScan(scene).render(7, other);
    ASSERT_EQ(first.size(), 1440U * 1080U);
    EXPECT_TRUE(first == again) << preset;
    EXPECT_FALSE(first == other) << preset;
  }
}

TEST(Sensor, GivesTheSameBytesToSeveralThreadsAtOnce)
{
  const SimulatedScan scan(scenePreset("harsh"));
  std::vector<std::uint8_t> alone;
  scan.render(3, alone);
  std::vector<std::vector<std::uint8_t>> together(3);
  std::vector<std::thread> threads;
  for (auto& pixels : together)
    threads.emplace_back([&scan, &pixels] { scan.render(3, pixels); });
  for (std::thread& thread : threads)
    thread.join();
  for (const auto& pixels : together)
    EXPECT_TRUE(pixels == alone);
}

TEST(Sensor, GivesEveryFrameItsOwnNoise)
{
  const SimulatedScan scan(noisyFlat());
  std::vector<std::uint8_t> a, b;
  scan.render(0, a);
  scan.render(1, b);
  EXPECT_FALSE(a == b);
}

TEST(Sensor, EncodesSixteenBitsOverTheFullRange)
{
  SceneParams scene = flatScene();
  scene.laser.peak = 400.0;
  const SimulatedScan scan(scene);
  EXPECT_EQ(scan.step(), 2880U);
  std::vector<std::uint8_t> bytes;
  scan.render(0, bytes);
  ASSERT_EQ(bytes.size(), 2880U * 1080U);
  std::uint16_t value = 0;
  std::memcpy(&value, &bytes[540U * 2880U + 1000U], 2);
  EXPECT_EQ(value, 65535);
  std::memcpy(&value, &bytes[100U * 2880U], 2);
  EXPECT_EQ(value, 5 * 257) << "black level";
}

TEST(Sensor, LightsTheRedPhotositesOfABayerImage)
{
  SceneParams scene = flatScene();
  scene.sensor.encoding = "bayer_rggb8";
  const SimulatedScan scan(scene);
  EXPECT_EQ(scan.step(), 1440U);
  const auto pixels = frameOf(scan, 0);
  const std::size_t even = 540U * 1440U + 700U;  // the stripe's row is even: red, green
  EXPECT_NEAR(pixels[even], 180.0, 1.0);
  EXPECT_NEAR(pixels[even + 1], 180.0 * 0.08, 1.0);
  EXPECT_NEAR(pixels[even + 1440], 180.0 * 0.08 * std::exp(-0.125), 1.0) << "the row below begins with green";
  EXPECT_NEAR(pixels[even + 1441], 180.0 * 0.03 * std::exp(-0.125), 1.0) << "... and has blue";
}

TEST(Sensor, PutsRedLastInABgrImage)
{
  SceneParams scene = flatScene();
  scene.sensor.encoding = "bgr8";
  const SimulatedScan scan(scene);
  EXPECT_EQ(scan.step(), 4320U);
  const auto pixels = frameOf(scan, 0);
  ASSERT_EQ(pixels.size(), 4320U * 1080U);
  const std::size_t pixel = 540U * 4320U + 3U * 700U;
  EXPECT_NEAR(pixels[pixel], 180.0 * 0.03, 1.0);
  EXPECT_NEAR(pixels[pixel + 1], 180.0 * 0.08, 1.0);
  EXPECT_NEAR(pixels[pixel + 2], 180.0, 1.0);
}
}  // namespace
}  // namespace weld_profiler
