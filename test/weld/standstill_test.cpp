#include <cmath>

#include <gtest/gtest.h>

#include "ideal_scan.h"
#include "weld_profiler/weld/weld_measurer.h"

using namespace weld_profiler;

namespace
{
/// A scan during which the stage stands still at one row, for `times` rows more; its encoder counts on by some 0.2 um.
Scan standingStill(const Scan& scan, std::size_t at, std::size_t times)
{
  Scan result = scan;
  result.rows.assign(scan.rows.begin(), scan.rows.begin() + static_cast<std::ptrdiff_t>(at));
  for (std::size_t i = 0; i <= times; ++i)
  {
    Profile row = scan.rows[at];
    for (CloudPoint& point : row.points)
      point.y += 2e-7F * static_cast<float>(i % 3);
    result.rows.push_back(row);
  }
  result.rows.insert(result.rows.end(), scan.rows.begin() + static_cast<std::ptrdiff_t>(at) + 1, scan.rows.end());
  return result;
}
}  // namespace

TEST(Standstill, DoesNotChangeWhatIsMeasured)
{
  const Scan moving = IdealScanner()(IdealWeld());
  const WeldResult expected = WeldMeasurer().measure(moving);
  ASSERT_GT(expected.measured_share, 0.99) << expected.reason;
  for (const std::size_t at : { std::size_t(0), std::size_t(30), moving.rows.size() - 1 })
  {
    const Scan scan = standingStill(moving, at, 150);
    const WeldResult result = WeldMeasurer().measure(scan);
    ASSERT_EQ(expected.sections.size(), result.sections.size()) << "at row " << at << ": " << result.reason;
    for (std::size_t i = 0; i < result.sections.size(); ++i)
    {
      EXPECT_NEAR(expected.sections[i].width.value, result.sections[i].width.value, 1e-6);
      EXPECT_NEAR(expected.sections[i].reinforcement.value, result.sections[i].reinforcement.value, 1e-6);
    }
    EXPECT_NEAR(expected.volume.value, result.volume.value, 1e-3 * expected.volume.value);
    // each of the rows has its labels
    for (std::size_t row = at; row <= at + 150; ++row)
      for (std::size_t cell = 0; cell < scan.cells; ++cell)
        ASSERT_EQ(expected.labels[at * scan.cells + cell], result.labels[row * scan.cells + cell])
            << row << ", " << cell;
  }
}
