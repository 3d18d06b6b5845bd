#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "made_cases.h"
#include "mesh_checks.h"
#include "plan_poses.h"
#include "weld_profiler/weld/grinding.h"

using namespace weld_profiler;

namespace
{
std::vector<SurfacePose> everyPose(const GrindingPlan& plan)
{
  std::vector<SurfacePose> poses;
  for (const auto* lines : { &plan.toe_left, &plan.toe_right, &plan.crest })
    for (const PoseLine& line : *lines)
      poses.insert(poses.end(), line.begin(), line.end());
  for (const GrindingPass& pass : plan.passes)
    for (const GrindingPoint& point : pass.points)
      poses.push_back(point.pose);
  return poses;
}

std::vector<MadeCase> cases()
{
  return bothWays({
      { "Straight", [](MadeWeld&) {} },
      { "Yawed", [](MadeWeld& weld) { weld.yaw = -20.0 * kDegree; } },
      { "Curved", [](MadeWeld& weld) { weld.bend = 1.0 / 0.08; } },
      { "Misaligned", [](MadeWeld& weld) { weld.misalignment = 0.5e-3; } },
      { "WithARest", [](MadeWeld& weld) { weld.rest = 0.2e-3; } },
      { "Narrowing", [](MadeWeld& weld) { weld.narrowing = 0.2; } },
      { "Noisy", [](MadeWeld& weld) { weld.sigma = 15e-6; } },
  });
}

class PlanFor : public ::testing::TestWithParam<MadeCase>
{
protected:
  PlanFor() : weld_(GetParam().weld)
  {
    weld_.make();
    plan_ = planGrinding(weld_.scan, weld_.result, params_);
  }

  double depthAt(double s, double q) const { return std::max(0.0, weld_.surface(s, q) - weld_.target(s, q)); }

  GrindingParams params_;
  MadeWeld weld_;
  GrindingPlan plan_;
};
}  // namespace

TEST_P(PlanFor, TravelsAlongTheWeldWithTheNormalUp)
{
  const std::vector<SurfacePose> poses = everyPose(plan_);
  ASSERT_GT(poses.size(), 100U);
  for (const SurfacePose& pose : poses)
  {
    ASSERT_NEAR(pose.orientation.norm(), 1.0, 1e-9);
    const Eigen::Vector3d x = axis(pose, 0), y = axis(pose, 1), z = axis(pose, 2);
    ASSERT_NEAR(x.cross(y).dot(z), 1.0, 1e-9) << "right-handed";
    ASSERT_GT(z.z(), 0.9) << "toward the sensor";
    const double yaw = weld_.yawAt(placeOf(weld_, pose).x());
    ASSERT_NEAR(std::atan2(-x.x(), x.y()), yaw, 0.01) << "along the weld";
  }
}

TEST_P(PlanFor, HasToesAndCrestWhereTheyAre)
{
  ASSERT_EQ(plan_.toe_left.size(), 1U);
  ASSERT_EQ(plan_.toe_right.size(), 1U);
  ASSERT_EQ(plan_.crest.size(), 1U);
  ASSERT_GE(plan_.toe_left[0].size(), 12U);
  ASSERT_EQ(plan_.toe_left[0].size(), plan_.toe_right[0].size());
  for (std::size_t i = 0; i < plan_.toe_left[0].size(); ++i)
  {
    const Eigen::Vector2d left = placeOf(weld_, plan_.toe_left[0][i]), right = placeOf(weld_, plan_.toe_right[0][i]);
    ASSERT_NEAR(left.y(), -0.5 * weld_.widthAt(left.x()), 5e-6);
    ASSERT_NEAR(right.y(), 0.5 * weld_.widthAt(right.x()), 5e-6);
    ASSERT_NEAR(plan_.toe_right[0][i].position.z(), -weld_.misalignment, 1e-6);
  }
  for (const SurfacePose& pose : plan_.crest[0])
  {
    const Eigen::Vector2d place = placeOf(weld_, pose);
    ASSERT_NEAR(place.y(), 0.0, 0.1e-3);
    ASSERT_NEAR(pose.position.z(), weld_.surface(place.x(), place.y()), 5e-6 + weld_.sigma);
  }
}

TEST_P(PlanFor, EndsOnTheTarget)
{
  ASSERT_FALSE(plan_.passes.empty());
  int last_layer = 0;
  for (const GrindingPass& pass : plan_.passes)
  {
    const double level = (plan_.layers - 1 - pass.layer) * params_.depth_per_pass;
    ASSERT_GE(level, -1e-12);
    last_layer = std::max(last_layer, pass.layer);
    for (const GrindingPoint& point : pass.points)
    {
      const Eigen::Vector2d place = placeOf(weld_, point.pose);
      ASSERT_NEAR(point.pose.position.z(), weld_.target(place.x(), place.y()) + level, 3e-6);
      const double tilt = std::atan2(weld_.misalignment, weld_.width);
      ASSERT_NEAR(std::acos(std::min(1.0, axis(point.pose, 2).z())), tilt, 0.3 * kDegree) << "normal of the target";
      ASSERT_LE(point.removal, params_.depth_per_pass + 1e-12);
    }
  }
  EXPECT_EQ(last_layer, plan_.layers - 1);
}

TEST_P(PlanFor, RemovesAllOfIt)
{
  double closed = 0.0;  // of what stands above the target
  for (double s = -0.5 * weld_.length() + 5e-5; s < 0.5 * weld_.length(); s += 1e-4)
    for (double q = -5e-3 + 1e-5; q < 5e-3; q += 2e-5)
      closed += depthAt(s, q) * 1e-4 * 2e-5 * (1.0 - q * weld_.bend);
  EXPECT_NEAR(plan_.removal_volume / closed, 1.0, 0.01);
  EXPECT_NEAR(plan_.planned_volume / closed, 1.0, 0.015);
  double sum = 0.0;
  for (const GrindingPass& pass : plan_.passes)
    for (const GrindingPoint& point : pass.points)
      sum += point.volume;
  EXPECT_DOUBLE_EQ(sum, plan_.planned_volume);
}

TEST_P(PlanFor, CoversTheWholeWidthOfTheBeadInTheLastLayer)
{
  ASSERT_FALSE(plan_.passes.empty());
  for (double s = -0.45 * weld_.length(); s < 0.45 * weld_.length(); s += 1e-3)
  {
    std::vector<double> middles;
    for (const GrindingPass& pass : plan_.passes)
      for (const GrindingPoint& point : pass.points)
      {
        const Eigen::Vector2d place = placeOf(weld_, point.pose);
        if (pass.layer == plan_.layers - 1 && std::abs(place.x() - s) <= 0.51 * params_.point_spacing)
          middles.push_back(place.y());
      }
    ASSERT_FALSE(middles.empty()) << "s " << s;
    std::sort(middles.begin(), middles.end());
    const double half = 0.5 * params_.tool_width, edge = 0.5 * weld_.widthAt(s) + params_.margin;
    EXPECT_LE(middles.front() - half, -edge + 0.15e-3) << "s " << s;  // a narrowing bead is wider half a step on
    EXPECT_GE(middles.back() + half, edge - 0.15e-3);
    for (std::size_t i = 1; i < middles.size(); ++i)
      EXPECT_LE(middles[i] - middles[i - 1], (1.0 - params_.overlap) * params_.tool_width + 1e-5);
  }
}

TEST_P(PlanFor, KeepsTheSpacingOfItsPoints)
{
  ASSERT_FALSE(plan_.passes.empty());
  for (const GrindingPass& pass : plan_.passes)
  {
    ASSERT_GE(pass.points.size(), 2U);
    for (std::size_t i = 1; i < pass.points.size(); ++i)
    {
      const double step = (pass.points[i].pose.position - pass.points[i - 1].pose.position).norm();
      ASSERT_GT(step, 0.8 * params_.point_spacing);
      ASSERT_LT(step, 1.1 * params_.point_spacing);  // on the outer side of a bend it is longer
    }
    EXPECT_NEAR((pass.approach.position - pass.points.front().pose.position).norm(), params_.approach_height, 1e-9);
    EXPECT_GT((pass.retract.position - pass.points.back().pose.position).dot(axis(pass.points.back().pose, 2)), 0.0);
  }
}

INSTANTIATE_TEST_SUITE_P(Welds, PlanFor, ::testing::ValuesIn(cases()), nameOf);
