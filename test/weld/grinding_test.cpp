#include "weld_profiler/weld/grinding.h"

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "plan_poses.h"
#include "weld_profiler/core/errors.h"
#include "weld_profiler/weld/grinding_csv.h"

using namespace weld_profiler;

TEST(Grinding, GoesDownLayerByLayer)
{
  MadeWeld weld;
  weld.make();
  GrindingParams params;
  params.depth_per_pass = 0.4e-3;
  const GrindingPlan plan = planGrinding(weld.scan, weld.result, params);
  EXPECT_EQ(plan.layers, 4);  // 1.5 mm
  ASSERT_FALSE(plan.passes.empty());
  EXPECT_EQ(plan.passes.front().layer, 0);
  std::vector<double> volumes(4, 0.0);
  for (std::size_t i = 0; i < plan.passes.size(); ++i)
  {
    EXPECT_GE(plan.passes[i].layer, plan.passes[i > 0 ? i - 1 : 0].layer) << "from the top down";
    for (const GrindingPoint& point : plan.passes[i].points)
      volumes[static_cast<std::size_t>(plan.passes[i].layer)] += point.volume;
  }
  const double radius = weld.radius(0.0);
  for (int layer = 0; layer < 4; ++layer)
  {
    double closed = 0.0;  // the circle's segment between two levels
    for (double q = -4e-3; q < 4e-3; q += 1e-6)
      closed += std::min(0.4e-3, std::max(0.0, std::sqrt(radius * radius - q * q) - (radius - weld.height) -
                                                   (3 - layer) * 0.4e-3)) *
                1e-6;
    EXPECT_NEAR(volumes[static_cast<std::size_t>(layer)] / (closed * weld.length()), 1.0, 0.03) << "layer " << layer;
  }
}

TEST(Grinding, NeedsOneLayerForALowBead)
{
  MadeWeld weld;
  weld.height = 0.25e-3;
  weld.make();
  const GrindingPlan plan = planGrinding(weld.scan, weld.result);
  EXPECT_EQ(plan.layers, 1);
  for (const GrindingPass& pass : plan.passes)
    for (const GrindingPoint& point : pass.points)
      EXPECT_NEAR(point.removal, 0.25e-3, 3e-6);
}

TEST(Grinding, NeverPassesOverAGap)
{
  MadeWeld weld;
  weld.holes = { { 2e-3, 4e-3, -0.02, 0.02 } };
  weld.make();
  const GrindingPlan plan = planGrinding(weld.scan, weld.result);
  ASSERT_FALSE(plan.passes.empty());
  int before = 0, behind = 0;
  for (const GrindingPass& pass : plan.passes)
  {
    const double first = placeOf(weld, pass.points.front().pose).x();
    const double last = placeOf(weld, pass.points.back().pose).x();
    before += last < 2.1e-3 ? 1 : 0;
    behind += first > 3.9e-3 ? 1 : 0;
  }
  EXPECT_GT(before, 0);
  EXPECT_GT(behind, 0);
  EXPECT_EQ(static_cast<std::size_t>(before + behind), plan.passes.size());
  EXPECT_EQ(plan.crest.size(), 2U);
}

namespace
{
/// Passes of a single lane over a narrow bead that have poses within 0.4 mm of its middle.
int passesAcrossTheMiddle(const MadeWeld& weld)
{
  const GrindingPlan plan = planGrinding(weld.scan, weld.result);
  EXPECT_FALSE(plan.passes.empty());
  int across = 0;
  for (const GrindingPass& pass : plan.passes)
  {
    const double first = placeOf(weld, pass.points.front().pose).x();
    const double last = placeOf(weld, pass.points.back().pose).x();
    EXPECT_EQ(pass.lane, 0);
    across += first < -0.4e-3 && last > 0.4e-3 ? 1 : 0;
  }
  return across;
}
}  // namespace

TEST(Grinding, PassesOverAWholeNarrowBead)
{
  MadeWeld weld;
  weld.width = 4e-3, weld.height = 0.5e-3;
  weld.make();
  EXPECT_EQ(passesAcrossTheMiddle(weld), 2) << "one a layer";
}

TEST(Grinding, NeverPassesWhereTheLanesMiddleIsNotTheBead)
{
  MadeWeld weld;
  weld.width = 4e-3, weld.height = 0.5e-3;
  weld.make();
  for (std::size_t row = 0; row < weld.scan.rows.size(); ++row)  // something lies on it that was not told
    for (const CloudPoint& point : weld.scan.rows[row].points)
      if (std::abs(weld.locate(point.x, point.y).x()) < 1e-3 && std::abs(point.x) < 0.5e-3F)
        weld.result.labels[row * weld.scan.cells + point.cell] = static_cast<std::uint8_t>(WeldLabel::Unknown);
  EXPECT_EQ(passesAcrossTheMiddle(weld), 0);
}

TEST(Grinding, NeverPassesWhereTooLittleOfTheLaneIsKnown)
{
  MadeWeld weld;
  weld.width = 4e-3, weld.height = 0.5e-3;
  weld.holes = { { -1e-3, 1e-3, 0.5e-3, 3e-3 } };
  weld.make();
  EXPECT_EQ(passesAcrossTheMiddle(weld), 0);
}

TEST(Grinding, SaysWhatItLeavesBesideHoles)
{
  MadeWeld weld;  // a hole along each lane's middle
  weld.holes = { { -8e-3, 8e-3, -1.6e-3, -0.8e-3 }, { -8e-3, 8e-3, -0.4e-3, 0.4e-3 }, { -8e-3, 8e-3, 0.8e-3, 1.6e-3 } };
  weld.make();
  const GrindingPlan plan = planGrinding(weld.scan, weld.result);
  EXPECT_GT(plan.removal_volume, 0.0);
  EXPECT_LT(plan.planned_volume, 0.9 * plan.removal_volume);
  EXPECT_NE(plan.reason.find("the rest lies beside holes in the data"), std::string::npos) << plan.reason;
}

TEST(Grinding, PassesOnlyWhereThereIsSomethingToRemove)
{
  MadeWeld weld;
  weld.make();
  for (int row = 0; row < weld.rows; ++row)  // the middle third was ground already
    for (CloudPoint& point : weld.scan.rows[static_cast<std::size_t>(row)].points)
      if (row >= 70 && row < 130)
        point.z = std::min(point.z, 0.0F);
  const GrindingPlan plan = planGrinding(weld.scan, weld.result);
  ASSERT_FALSE(plan.passes.empty());
  for (const GrindingPass& pass : plan.passes)
    for (const GrindingPoint& point : pass.points)
      EXPECT_GT(std::abs(placeOf(weld, point.pose).x()), 2e-3);
  GrindingParams params;
  params.bridge_length = 0.02;
  const GrindingPlan bridged = planGrinding(weld.scan, weld.result, params);
  EXPECT_EQ(2 * bridged.passes.size(), plan.passes.size());
}

TEST(Grinding, TravelsBackOnEveryOtherLaneWhenAsked)
{
  MadeWeld weld;
  weld.make();
  GrindingParams params;
  params.order = "alternate";
  params.tool_width = 3e-3;
  const GrindingPlan plan = planGrinding(weld.scan, weld.result, params);
  int back = 0;
  for (const GrindingPass& pass : plan.passes)
  {
    ASSERT_GE(pass.points.size(), 2U);
    const Eigen::Vector3d travel = pass.points[1].pose.position - pass.points[0].pose.position;
    back += travel.y() < 0.0 ? 1 : 0;
    EXPECT_EQ(travel.y() < 0.0, pass.lane % 2 == 1);
    for (const GrindingPoint& point : pass.points)
    {
      EXPECT_GT(axis(point.pose, 0).dot(travel.normalized()), 0.999);
      EXPECT_GT(axis(point.pose, 2).z(), 0.99);
    }
    EXPECT_NEAR((pass.approach.position - pass.points.front().pose.position).norm(), params.approach_height, 1e-9);
    EXPECT_GT(axis(pass.approach, 0).dot(travel.normalized()), 0.999);
  }
  EXPECT_GT(back, 0);
}

TEST(Grinding, WritesPassesAsALineAPose)
{
  MadeWeld weld;
  weld.height = 0.25e-3;
  weld.make();
  const GrindingPlan plan = planGrinding(weld.scan, weld.result);
  std::ostringstream out;
  writePassesCsv(plan, out);
  std::istringstream lines(out.str());
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "pass,point,x_m,y_m,z_m,qx,qy,qz,qw,removal_m");
  std::size_t poses = 0;
  for (const GrindingPass& pass : plan.passes)
    poses += pass.points.size();
  std::size_t count = 0;
  while (std::getline(lines, line))
  {
    EXPECT_EQ(std::count(line.begin(), line.end(), ','), 9);
    ++count;
  }
  ASSERT_GT(poses, 0U);
  EXPECT_EQ(count, poses);
}

TEST(Grinding, SaysWhyThereIsNothingToDo)
{
  MadeWeld weld;
  weld.make();
  WeldResult none = weld.result;
  none.kind = WeldKind::None;
  none.reason = "no bead stands out";
  const GrindingPlan empty = planGrinding(weld.scan, none);
  EXPECT_EQ(empty.reason, "no bead stands out");
  EXPECT_EQ(empty.frame_id, "weld_profiler_scan");
  EXPECT_TRUE(empty.passes.empty() && empty.bead.empty() && empty.target.empty() && empty.crest.empty());

  MadeWeld flat;
  flat.height = 1e-5;
  flat.make();
  const GrindingPlan done = planGrinding(flat.scan, flat.result);
  EXPECT_EQ(done.reason, "nothing stands more than min_removal (0.02 mm) above the target");
  EXPECT_TRUE(done.passes.empty());
  EXPECT_FALSE(done.target.empty());

  GrindingParams thin;
  thin.depth_per_pass = 1e-5;
  thin.min_removal = 1e-6;
  MadeWeld high;
  high.height = 5.5e-3, high.width = 14e-3;
  high.make();
  const GrindingPlan many = planGrinding(high.scan, high.result, thin);
  EXPECT_NE(many.reason.find("layers"), std::string::npos) << many.reason;
  EXPECT_TRUE(many.passes.empty());
}

TEST(Grinding, RefusesAResultOfAnotherScan)
{
  MadeWeld weld;
  weld.make();
  weld.scan.rows.pop_back();
  EXPECT_THROW(planGrinding(weld.scan, weld.result), PreconditionError);
}
