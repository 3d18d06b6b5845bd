#include "weld/weld_path.h"

#include <cmath>

#include <gtest/gtest.h>

using weld_profiler::weld::PathPlace;
using weld_profiler::weld::PathSample;
using weld_profiler::weld::WeldPath;

namespace
{
/// 20 mm of a path oblique by 0.2 rad whose curvature has a radius of 100 mm.
WeldPath curvedPath()
{
  std::vector<PathSample> samples;
  for (int i = 0; i <= 200; ++i)
  {
    const double y = 1e-4 * i;
    samples.push_back(PathSample{ 0.2 * y + 5.0 * y * y, y, 1e-6 });
  }
  return WeldPath(samples, 0.0, 0.02, 0.01);
}
}  // namespace

TEST(WeldPath, PlacesPointsTogetherAsOneByOne)
{
  const WeldPath path = curvedPath();
  // from a near guess all take its frame, from a far one each looks for its own
  for (const double guess : { 0.010, 0.002 })
  {
    WeldPath::Together points;
    for (std::size_t i = 0; i < WeldPath::kTogether; ++i)
    {
      points.x[i] = 0.004 + 1.5e-5 * static_cast<double>(i);
      points.y[i] = 0.0093;
    }
    path.locate(guess, points);
    for (std::size_t i = 0; i < WeldPath::kTogether; ++i)
    {
      // to the second order between frames 0.25 mm apart: a turn of 1e-3 rad, whose cube is nothing
      const PathPlace alone = path.locate(points.x[i], points.y[i], guess);
      EXPECT_NEAR(alone.q, points.q[i], 1e-9) << i << " from " << guess;
      EXPECT_NEAR(alone.s, points.s[i], 1e-9) << i << " from " << guess;
    }
  }
}

TEST(WeldPath, PlacesAPointWhereItsFootLies)
{
  const WeldPath path = curvedPath();
  for (const double s : { 0.004, 0.0101, 0.0173 })
  {
    for (const double q : { -0.006, 0.0, 0.009 })
    {
      const auto foot = path.at(s);
      const double x = foot.x + std::cos(foot.yaw) * q, y = foot.y + std::sin(foot.yaw) * q;
      const PathPlace place = path.locate(x, y, s + 0.003);
      EXPECT_NEAR(q, place.q, 2e-7);
      EXPECT_NEAR(s, place.s, 2e-7);
    }
  }
}
