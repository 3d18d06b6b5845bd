#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "weld/ideal_scan.h"
#include "weld_profiler/weld/live_weld.h"

// Live values of welds that run obliquely: nobody tells them the yaw.

namespace weld_profiler
{
namespace
{
constexpr double kDegree = M_PI / 180.0;

IdealWeld fillet()
{
  IdealWeld weld;
  weld.width = 0.006, weld.height = 0.0004, weld.angle = 70.0 * kDegree;
  return weld;
}

const std::vector<std::pair<const char*, Quantity WeldSection::*>> kOfARow{
  { "width", &WeldSection::width },
  { "reinforcement", &WeldSection::reinforcement },
  { "height_left", &WeldSection::height_left },
  { "height_right", &WeldSection::height_right },
  { "leg_left", &WeldSection::leg_left },
  { "leg_right", &WeldSection::leg_right },
  { "throat", &WeldSection::throat },
  { "area", &WeldSection::area },
  { "angle", &WeldSection::angle },
  { "toe_angle_left", &WeldSection::toe_angle_left },
  { "toe_angle_right", &WeldSection::toe_angle_right },
};
}  // namespace

TEST(LiveWeld, TellsTheYawFromTheRowsSoFarAndHowUncertainItIs)
{
  for (const double yaw : { 0.0, -20.0 * kDegree, 12.0 * kDegree })
  {
    IdealWeld weld;
    weld.yaw = yaw;
    const Scan scan = IdealScanner()(weld);
    const WeldMeasurer measurer;
    LiveWeld live(measurer);
    int told = 0;
    for (const Profile& row : scan.rows)
    {
      const WeldSection section = live.measure(row);
      if (!section.hasBead())
        continue;
      ++told;
      EXPECT_LT(std::abs(section.width.value - weld.width), 3.5 * section.width.sigma + 2e-5) << row.stage;
      EXPECT_LT(std::abs(section.yaw - yaw), 3.0 * section.yaw_sigma) << row.stage;
      EXPECT_GT(section.width.sigma, row.stage < 5e-4 ? 2e-4 : 0.0) << "at first nothing is known of the yaw";
    }
    ASSERT_GE(told, 50);
    const WeldSection last = live.measure(scan.rows.back());
    EXPECT_LT(last.yaw_sigma, 1.5 * kDegree);
    EXPECT_LT(last.width.sigma, 1.5e-4);
    EXPECT_DOUBLE_EQ(last.stage, scan.rows.back().stage);
  }
}

TEST(LiveWeld, TakesNothingOverFromTheWeldBefore)
{
  IdealWeld weld;
  weld.yaw = 20.0 * kDegree;
  const WeldMeasurer measurer;
  LiveWeld live(measurer);
  for (const Profile& row : IdealScanner()(weld).rows)
    live.measure(row);
  live.restart();
  const WeldSection first = live.measure(IdealScanner()(IdealWeld()).rows.front());
  EXPECT_EQ(first.yaw, 0.0);
  EXPECT_DOUBLE_EQ(first.yaw_sigma, 0.35);
}

TEST(LiveWeld, ARowsSigmasHoldWhatItsYawLeavesUncertain)
{
  WeldParams params;
  params.kind = "fillet";
  const WeldMeasurer measurer(params);
  IdealWeld weld = fillet();
  weld.yaw = 15.0 * kDegree;
  const Profile row = IdealScanner()(weld).rows[30];
  const double sigma = 6.0 * kDegree;
  const WeldSection known = measurer.measureRow(row, { weld.yaw, 0.0 });
  const WeldSection uncertain = measurer.measureRow(row, { weld.yaw, sigma });
  const WeldSection less = measurer.measureRow(row, { weld.yaw - sigma, 0.0 });
  const WeldSection more = measurer.measureRow(row, { weld.yaw + sigma, 0.0 });
  for (const auto& [what, quantity] : kOfARow)
  {
    ASSERT_TRUE((known.*quantity).measured()) << what;
    EXPECT_DOUBLE_EQ((uncertain.*quantity).value, (known.*quantity).value) << what;
    const double change = 0.5 * std::abs((more.*quantity).value - (less.*quantity).value);
    const double grown = std::sqrt(std::pow((uncertain.*quantity).sigma, 2.0) - std::pow((known.*quantity).sigma, 2.0));
    EXPECT_NEAR(grown, change, 0.25 * change + 0.2 * (known.*quantity).sigma) << what;
  }
  EXPECT_GT(uncertain.toe_left.y.sigma, known.toe_left.y.sigma + 1e-4);
}

TEST(LiveWeld, AYawThatIsNoNumberIsRefused)
{
  const Profile row = IdealScanner()(IdealWeld()).rows[3];
  EXPECT_THROW(WeldMeasurer().measureRow(row, { NAN, 0.0 }), std::exception);
  EXPECT_THROW(WeldMeasurer().measureRow(row, { 0.0, NAN }), std::exception);
  EXPECT_THROW(WeldMeasurer().measureRow(row, { 0.0, -0.1 }), std::exception);
}
}  // namespace weld_profiler
