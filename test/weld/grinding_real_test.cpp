#include <gtest/gtest.h>

#include "made_weld.h"
#include "mesh_checks.h"
#include "weld_profiler/weld/grinding.h"
#include "weld_profiler/weld/weld_measurer.h"

using namespace weld_profiler;

namespace
{
MadeWeld madeScan(bool flipped)
{
  MadeWeld weld;
  weld.cells = 1440;
  weld.spacing = 42e-6;
  weld.sigma = 8e-6;
  weld.yaw = 5.0 * kDegree;
  weld.misalignment = 0.2e-3;
  weld.flipped = flipped;
  weld.make();
  return weld;
}
}  // namespace

class MeasuredWeld : public ::testing::TestWithParam<bool>
{
};

TEST_P(MeasuredWeld, IsPlannedAsItIs)
{
  const MadeWeld weld = madeScan(GetParam());
  const WeldResult result = WeldMeasurer().measure(weld.scan);
  ASSERT_TRUE(result.hasWeld()) << result.reason;
  const GrindingPlan plan = planGrinding(weld.scan, result);
  EXPECT_EQ(plan.reason, "");
  ASSERT_FALSE(plan.passes.empty());
  for (const TriangleMesh* mesh : { &plan.bead, &plan.target })
  {
    ASSERT_FALSE(mesh->empty());
    EXPECT_TRUE(faultsOf(*mesh).none());
    EXPECT_EQ(pieces(*mesh), 1);
    EXPECT_GT(sharpestCorner(*mesh), 15.0 * kDegree);
  }
  EXPECT_NEAR(plan.removal_volume / result.removal_volume.value, 1.0, 0.01);
  EXPECT_NEAR(plan.planned_volume / result.removal_volume.value, 1.0, 0.015);
  for (const GrindingPass& pass : plan.passes)
    for (const GrindingPoint& point : pass.points)
    {
      const Eigen::Vector2d place = weld.locate(point.pose.position.x(), point.pose.position.y());
      const double level = (plan.layers - 1 - pass.layer) * GrindingParams().depth_per_pass;
      EXPECT_NEAR(point.pose.position.z(), weld.target(place.x(), place.y()) + level, 0.02e-3);
      EXPECT_GT(point.pose.orientation.toRotationMatrix()(1, 0), 0.98) << "travels along the weld";
    }
}

INSTANTIATE_TEST_SUITE_P(EitherAxis, MeasuredWeld, ::testing::Values(false, true));
