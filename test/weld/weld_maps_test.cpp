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
