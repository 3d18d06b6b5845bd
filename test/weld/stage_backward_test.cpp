#include <gtest/gtest.h>

#include "weld/ideal_scan.h"
#include "weld_profiler/weld/grinding.h"
#include "weld_profiler/weld/live_weld.h"

// A stage that runs backward, toward -y: what is told is along +y all the same.

namespace weld_profiler
{
namespace
{
Scan scanned(double pitch)
{
  IdealWeld weld;
  weld.yaw = 0.1;
  weld.undercut = 0.0004;
  IdealScanner scanner;
  scanner.pitch = pitch;
  scanner.first_y = pitch < 0.0 ? 0.0118 : 0.0;
  return scanner(weld);
}
}  // namespace

TEST(StageBackward, SectionsAndSRiseWithYAndLeftIsSeenAlongY)
{
  const Scan scan = scanned(-2e-4);
  const WeldResult result = WeldMeasurer().measure(scan);
  ASSERT_GE(result.sections.size(), 50u);
  EXPECT_GT(result.sections.front().row, result.sections.back().row) << "the row seen last is first";
  EXPECT_GT(result.sections.front().stage, -1.0);
  EXPECT_LT(result.sections.front().stage, result.sections.back().stage);
  EXPECT_LT(result.sections.front().s, result.sections.back().s);
  const WeldSection& middle = result.sections[result.sections.size() / 2];
  EXPECT_LT(result.sections[10].toe_left.y.value, middle.toe_left.y.value);
  EXPECT_LT(middle.toe_left.x.value, middle.toe_right.x.value);
  EXPECT_NEAR(middle.undercut_right.value, 0.0004, 3e-5);
  EXPECT_NEAR(middle.undercut_left.value, 0.0, 3e-5);
  EXPECT_NEAR(middle.yaw, 0.1, 0.01);
}

TEST(StageBackward, TellsTheSameAsForward)
{
  const WeldResult forward = WeldMeasurer().measure(scanned(2e-4)), backward = WeldMeasurer().measure(scanned(-2e-4));
  ASSERT_EQ(forward.sections.size(), backward.sections.size());
  int measured = 0;
  for (std::size_t i = 0; i < forward.sections.size(); ++i)
  {
    const WeldSection &a = forward.sections[i], &b = backward.sections[i];
    EXPECT_NEAR(a.s, b.s, 1e-5);
    if (!a.hasBead() || !b.hasBead())
      continue;
    ++measured;
    EXPECT_NEAR(a.width.value, b.width.value, 5.0 * a.width.sigma) << i;
    EXPECT_NEAR(a.toe_left.x.value, b.toe_left.x.value, 5.0 * a.toe_left.x.sigma) << i;
  }
  EXPECT_GE(measured, 50);
}

TEST(StageBackward, PassesTravelTowardY)
{
  const Scan scan = scanned(-2e-4);
  const GrindingPlan plan = planGrinding(scan, WeldMeasurer().measure(scan));
  ASSERT_FALSE(plan.passes.empty()) << plan.reason;
  for (const GrindingPass& pass : plan.passes)
  {
    ASSERT_GE(pass.points.size(), 2u);
    EXPECT_LT(pass.points.front().pose.position.y(), pass.points.back().pose.position.y());
    EXPECT_GT((pass.points.front().pose.orientation * Eigen::Vector3d::UnitX()).y(), 0.9);
  }
}

TEST(StageBackward, LiveValuesTellTheSameYaw)
{
  LiveWeld live{ WeldMeasurer() };
  const Scan scan = scanned(-2e-4);
  for (const Profile& row : scan.rows)
    live.measure(row);
  const WeldSection last = live.measure(scan.rows.back());
  EXPECT_NEAR(last.yaw, 0.1, 3.0 * last.yaw_sigma);
  EXPECT_LT(last.yaw_sigma, 0.03);
}
}  // namespace weld_profiler
