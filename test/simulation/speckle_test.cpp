#include <cmath>

#include <gtest/gtest.h>

#include "simulation/scenes.h"

namespace weld_profiler
{
namespace
{
std::size_t at(const SimulatedScan& scan, int u, int v)
{
  return static_cast<std::size_t>(v) * static_cast<std::size_t>(scan.width()) + static_cast<std::size_t>(u);
}

/// Correlation of two rows of speckle.
double correlation(const std::vector<double>& a, const std::vector<double>& b)
{
  double mean_a = 0.0, mean_b = 0.0, ab = 0.0, aa = 0.0, bb = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    mean_a += a[i] / a.size(), mean_b += b[i] / b.size();
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    ab += (a[i] - mean_a) * (b[i] - mean_b);
    aa += (a[i] - mean_a) * (a[i] - mean_a);
    bb += (b[i] - mean_b) * (b[i] - mean_b);
  }
  return ab / std::sqrt(aa * bb);
}

std::vector<double> row(const SimulatedScan& scan, int frame, int v, int first = 0, int count = 1430)
{
  const auto pixels = frameOf(scan, frame);
  return std::vector<double>(pixels.begin() + at(scan, first, v), pixels.begin() + at(scan, first + count, v));
}

TEST(Speckle, HasSpeckleOfTheAskedContrastAndGrain)
{
  SceneParams scene = flatScene();
  scene.speckle.contrast = 0.1;
  scene.frame_count = 6;
  scene.speed = 0.05;  // 2.5 mm a frame: new surface each time
  const SimulatedScan scan(scene);
  double contrast = 0.0, along = 0.0, along2 = 0.0, across = 0.0;
  for (int frame = 0; frame < 6; ++frame)
  {
    const auto middle = row(scan, frame, 540);
    double mean = 0.0, squares = 0.0;
    for (const double value : middle)
      mean += value / middle.size(), squares += value * value / middle.size();
    contrast += std::sqrt(squares - mean * mean) / mean / 6;
    EXPECT_NEAR(mean, 180.0, 2.0);
    along += correlation(middle, row(scan, frame, 540, 1)) / 6;
    along2 += correlation(middle, row(scan, frame, 540, 2)) / 6;
    across += correlation(middle, row(scan, frame, 541)) / 6;
  }
  EXPECT_NEAR(contrast, 0.1, 0.006);  // 6 x 700 grains: 1 %; mixing of the tile's points 3 %
  EXPECT_NEAR(along, 0.5, 0.06) << "half of the correlation at half of the full width of 2 px";
  EXPECT_NEAR(across, 0.5, 0.06);
  EXPECT_NEAR(along2, 0.0625, 0.06);
}

TEST(Speckle, CarriesItsSpeckleWithTheSurface)
{
  SceneParams scene = flatScene();
  scene.speckle.contrast = 0.1;
  scene.frame_count = 2;
  // on the flat plate a pixel down is sqrt(4/3) 0.25 / 6000 m of surface, toward the camera
  scene.speed = 2.0 * 0.25 / 6000.0 / std::cos(M_PI / 6) * scene.frame_rate;
  const SimulatedScan scan(scene);
  const auto before = row(scan, 0, 541);
  const double up = correlation(before, row(scan, 1, 539));
  const double still = correlation(before, row(scan, 1, 541));
  const double down = correlation(before, row(scan, 1, 543));
  EXPECT_GT(std::max(up, down), 0.98);
  EXPECT_LT(std::abs(still), 0.2);
  EXPECT_LT(std::min(up, down), 0.2);
}
}  // namespace
}  // namespace weld_profiler
