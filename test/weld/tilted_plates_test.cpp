#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "weld/ideal_scan.h"
#include "weld/made_weld.h"
#include "weld_profiler/weld/weld_measurer.h"

using namespace weld_profiler;

namespace
{
/// Sections whose value is told, and the largest error among them in its sigmas.
struct Judged
{
  int told = 0;
  double worst = 0.0;

  void add(const Quantity& value, double truth)
  {
    if (!value.measured())
      return;
    ++told;
    worst = std::max(worst, std::abs(value.value - truth) / value.sigma);
  }
};
}  // namespace

// An oblique weld runs out of view: from 18 mm on its left plate is hidden, then less of the bead is seen row by row.
TEST(TiltedPlates, AreContinuedAsPlanesBesideAnObliqueWeld)
{
  IdealWeld weld;
  weld.width = 0.010, weld.height = 0.0005, weld.yaw = 0.35, weld.misalignment = 0.0005;
  weld.x = -0.006;
  const double tilt = 0.26;
  const auto surface = [&](double x, double y) { return weld(x, y) + std::tan(tilt) * x; };
  IdealScanner scanner;
  scanner.rows = 130;
  const WeldResult result = WeldMeasurer().measure(scanner(surface));
  ASSERT_GT(result.sections.size(), 120u);
  ASSERT_EQ(result.path.size(), result.sections.size());
  // the step is upright, the plates are tilted by this across the weld
  const double slope = std::tan(tilt) * std::cos(weld.yaw);
  Judged misalignment;
  for (const WeldSection& section : result.sections)
    misalignment.add(section.misalignment, weld.misalignment / std::sqrt(1.0 + slope * slope));
  int widths = 0;
  for (std::size_t k = 0; k < result.sections.size(); ++k)
    widths += result.sections[k].hasBead() && result.path[k].y > 0.003 && result.path[k].y < 0.017 ? 1 : 0;
  EXPECT_GT(misalignment.told, 120);
  EXPECT_LT(misalignment.worst, 5.0);
  EXPECT_GT(widths, 65) << "of 70: where both toes are in view";
}

// Rolled plates, a pipe's end: what lies beside a curved fillet is no plane.
TEST(TiltedPlates, ThatFollowACurvedFilletAreEvenedOutAlongIt)
{
  MadeWeld weld;
  weld.slope_left = weld.slope_right = 1.0, weld.height = 0.0005, weld.bend = 8.0, weld.sigma = 2e-6;
  const WeldResult result = WeldMeasurer().measure(weld.make().scan);
  ASSERT_GT(result.sections.size(), 150u);
  Judged width, angle;
  for (const WeldSection& section : result.sections)
  {
    width.add(section.width, weld.width);
    angle.add(section.angle, 0.5 * M_PI);
  }
  EXPECT_GT(width.told, 150);
  EXPECT_LT(width.worst, 5.0);
  EXPECT_LT(angle.worst, 5.0);
}
