#include <cmath>

#include <gtest/gtest.h>

#include "support/circle_segment.h"
#include "weld/ideal_scan.h"
#include "weld_profiler/weld/weld_measurer.h"

// What a result says of every point of a scan.

namespace weld_profiler
{
TEST(WeldMaps, AddUpVolumeAndWhatIsToBeRemoved)
{
  const IdealWeld weld;
  const IdealScanner scanner;
  const Scan scan = scanner(weld);
  const double area = segmentArea(0.008, 0.0015);
  const WeldResult flush = WeldMeasurer().measure(scan);
  const double length = scanner.rows * scanner.pitch;
  EXPECT_NEAR(flush.volume.value, area * length, 0.005 * area * length);
  EXPECT_NEAR(flush.removal_volume.value, flush.volume.value, 1e-3 * flush.volume.value);
  WeldParams params;
  params.target = "rest";
  params.rest_height = 0.0005;
  const WeldResult rest = WeldMeasurer(params).measure(scan);
  EXPECT_LT(rest.removal_volume.value, 0.7 * flush.removal_volume.value);
  const std::size_t middle = 30u * scan.cells + scan.cells / 2;
  EXPECT_NEAR(flush.removal[middle], 0.0015, 1e-5);
  EXPECT_NEAR(rest.removal[middle], 0.0010, 1e-5);
  EXPECT_NEAR(rest.target[middle], 0.0005, 5e-6);
}

/// A fillet with equal legs between plates at right angles, all of it turned about y; its face is a circle's arc.
struct TiltedFillet
{
  double leg = 0.006, height = 0.0014, tilt = 20.0 * M_PI / 180.0;

  double width() const { return leg * std::sqrt(2.0); }
  double radius() const { return 0.5 * (0.25 * width() * width() + height * height) / height; }
  double toe(int side) const { return side * leg * std::cos(0.25 * M_PI + side * tilt); }
  double plate(double x) const { return std::tan((x < 0.0 ? -0.25 : 0.25) * M_PI + tilt) * x; }
  double chord(double x) const { return plate(toe(1)) + std::tan(tilt) * (x - toe(1)); }

  double operator()(double x, double /*y*/) const
  {
    if (x <= toe(-1) || x >= toe(1))
      return plate(x);
    const double down = radius() - height, middle = 0.5 * (toe(-1) + toe(1));
    const double centre_x = middle + down * std::sin(tilt), centre_z = chord(middle) - down * std::cos(tilt);
    return centre_z + std::sqrt(radius() * radius() - (x - centre_x) * (x - centre_x));
  }
};

TEST(WeldMaps, LeaveTheRestHeightAlongTheChordsNormal)
{
  const TiltedFillet weld;
  IdealScanner scanner;
  scanner.cells = 700;
  const Scan scan = scanner(weld);
  WeldParams params;
  params.target = "rest";
  params.rest_height = 0.0005;
  const WeldResult result = WeldMeasurer(params).measure(scan);
  ASSERT_EQ(result.kind, WeldKind::Fillet) << result.reason;
  int on_bead = 0;
  for (std::size_t row : { 10u, 30u, 50u })
  {
    for (const CloudPoint& point : scan.rows[row].points)
    {
      const auto x = static_cast<double>(point.x);
      if (x < weld.toe(-1) + 2e-4 || x > weld.toe(1) - 2e-4)
        continue;
      const std::size_t at = row * scan.cells + point.cell;
      const double target = weld.chord(x) + params.rest_height / std::cos(weld.tilt);
      // parents' lines where they are extrapolated to at the steeper toe, over the cosine of 65 deg
      ASSERT_NEAR(result.target[at], target, 8e-6) << "x " << x;
      EXPECT_NEAR(result.removal[at], std::max(0.0, weld(x, 0.0) - target), 1.5e-5) << "x " << x;
      ++on_bead;
    }
  }
  EXPECT_GT(on_bead, 500);
  // what lies above a line parallel to the chord is a smaller segment of the same circle, however it is turned
  const double left = weld.height - params.rest_height;
  const double half = std::sqrt(left * (2.0 * weld.radius() - left));
  const double truth = segmentArea(2.0 * half, left) * scanner.rows * scanner.pitch;
  EXPECT_NEAR(result.removal_volume.value, truth, 0.005 * truth);
}

TEST(WeldMaps, LabelEveryPoint)
{
  IdealWeld weld;
  weld.undercut = 0.0003;
  const IdealScanner scanner;
  const WeldResult result = WeldMeasurer().measure(scanner(weld));
  ASSERT_EQ(result.labels.size(), 60000u);
  int wrong = 0;
  for (int cell = 0; cell < scanner.cells; ++cell)
  {
    const double x = (cell - 0.5 * scanner.cells) * scanner.spacing;
    const auto label = static_cast<WeldLabel>(result.labels[30u * 1000u + static_cast<std::size_t>(cell)]);
    const WeldLabel truth = std::abs(x) < 0.004        ? WeldLabel::Bead
                            : x > 0.0042 && x < 0.0048 ? WeldLabel::Undercut
                                                       : WeldLabel::Base;
    const bool rim = x > 0.0038 && x < 0.0051;
    wrong += label != truth && !rim ? 1 : 0;
    if (truth == WeldLabel::Undercut)
    {
      EXPECT_EQ(label, WeldLabel::Undercut) << "x " << x;
    }
  }
  EXPECT_LE(wrong, 3) << "cells at the left toe";
}
}  // namespace weld_profiler
