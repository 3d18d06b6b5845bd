// Fillets: the target is the chord of the toes, tilted with the part, and beside it the parents rise.
#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "mesh_checks.h"
#include "plan_poses.h"
#include "weld_profiler/weld/grinding.h"
#include "weld_profiler/weld/weld_measurer.h"

using namespace weld_profiler;

namespace
{
/// The chord's fall to the right over its width, and the plates' slopes.
struct Lie
{
  std::string name;
  double fall, left, right;
};

void PrintTo(const Lie& lie, std::ostream* out)
{
  *out << lie.name;
}

/// Legs at 45 deg to either side; and a part tilted by 35 deg, so that one leg lies nearly flat.
std::vector<Lie> lies()
{
  const auto slope = [](double degrees) { return std::tan(degrees * kDegree); };
  return { { "BothAt45", 0.0, slope(45.0), slope(45.0) },
           { "RightLegSteep", -slope(30.0), slope(15.0), slope(65.0) },
           { "LeftLegSteep", slope(30.0), slope(65.0), slope(15.0) } };
}

class Fillet : public ::testing::TestWithParam<std::tuple<Lie, bool>>
{
protected:
  Fillet()
  {
    const Lie& lie = std::get<0>(GetParam());
    weld_.height = 0.8e-3;
    weld_.misalignment = lie.fall * weld_.width;
    weld_.slope_left = lie.left, weld_.slope_right = lie.right;
    weld_.flipped = std::get<1>(GetParam());
    weld_.make();
    tilt_ = std::atan(lie.fall);
    normal_ = { std::sin(tilt_), 0.0, std::cos(tilt_) };
    face_ = weld_.width / std::cos(tilt_);
    plan_ = planGrinding(weld_.scan, weld_.result, params_);
  }

  /// Along the chord from its left toe (x), above it (y).
  Eigen::Vector2d onChord(const SurfacePose& pose) const
  {
    const double q = placeOf(weld_, pose).y() + 0.5 * weld_.width;
    const Eigen::Vector2d from(q, pose.position.z());
    return { from.dot(Eigen::Vector2d(std::cos(tilt_), -std::sin(tilt_))),
             from.dot(Eigen::Vector2d(std::sin(tilt_), std::cos(tilt_))) };
  }

  GrindingParams params_;
  MadeWeld weld_;
  double tilt_ = 0.0, face_ = 0.0;
  Eigen::Vector3d normal_;
  GrindingPlan plan_;
};
}  // namespace

TEST_P(Fillet, IsGroundAlongTheNormalOfTheChord)
{
  EXPECT_EQ(plan_.reason, "");
  ASSERT_FALSE(plan_.passes.empty());
  for (const GrindingPass& pass : plan_.passes)
    for (const GrindingPoint& point : pass.points)
    {
      EXPECT_LT(std::acos(std::min(1.0, axis(point.pose, 2).dot(normal_))), 0.5 * kDegree);
      EXPECT_GT(axis(point.pose, 2).z(), 0.0) << "toward the sensor";
      EXPECT_GT(axis(point.pose, 0).y(), 0.99) << "along the weld";
    }
  for (const GrindingPass& pass : plan_.passes)
    EXPECT_GT((pass.approach.position - pass.points.front().pose.position).dot(normal_),
              0.99 * params_.approach_height);
}

TEST_P(Fillet, HasLayersThatDeepAlongTheNormal)
{
  const double height = weld_.height * std::cos(tilt_);  // the made face rises along z
  EXPECT_EQ(plan_.layers, static_cast<int>(std::ceil(height / params_.depth_per_pass)));
  double highest = 0.0;
  for (const GrindingPass& pass : plan_.passes)
    for (const GrindingPoint& point : pass.points)
    {
      EXPECT_NEAR(onChord(point.pose).y(), (plan_.layers - 1 - pass.layer) * params_.depth_per_pass, 8e-6);
      EXPECT_LE(point.removal, params_.depth_per_pass + 1e-12);
      if (pass.layer == 0)
        highest = std::max(highest, point.removal);
    }
  EXPECT_NEAR(highest, height - (plan_.layers - 1) * params_.depth_per_pass, 0.01e-3);
}

TEST_P(Fillet, KeepsTheToolBetweenThePlates)
{
  double first = face_, last = 0.0;
  for (const GrindingPass& pass : plan_.passes)
    for (const GrindingPoint& point : pass.points)
    {
      const double place = onChord(point.pose).x();
      EXPECT_GE(place - 0.5 * params_.tool_width, -0.03e-3) << "into the left plate";
      EXPECT_LE(place + 0.5 * params_.tool_width, face_ + 0.03e-3) << "into the right plate";
      if (pass.layer == plan_.layers - 1)
        first = std::min(first, place), last = std::max(last, place);
    }
  EXPECT_NEAR(first, 0.5 * params_.tool_width, 0.05e-3) << "the last layer reaches the toes";
  EXPECT_NEAR(last, face_ - 0.5 * params_.tool_width, 0.05e-3);
}

TEST_P(Fillet, LosesNoVolume)
{
  EXPECT_NEAR(plan_.removal_volume / (weld_.segmentArea() * weld_.length()), 1.0, 0.01);
  EXPECT_NEAR(plan_.planned_volume / plan_.removal_volume, 1.0, 0.01);
}

TEST_P(Fillet, HasMeshesThatFaceTheSensor)
{
  for (const TriangleMesh* mesh : { &plan_.bead, &plan_.target })
  {
    ASSERT_FALSE(mesh->empty());
    EXPECT_TRUE(faultsOf(*mesh).none());
    EXPECT_EQ(pieces(*mesh), 1);
  }
}

INSTANTIATE_TEST_SUITE_P(Lying, Fillet, ::testing::Combine(::testing::ValuesIn(lies()), ::testing::Bool()),
                         [](const ::testing::TestParamInfo<std::tuple<Lie, bool>>& info)
                         { return std::get<0>(info.param).name + (std::get<1>(info.param) ? "Flipped" : ""); });

TEST(FilletGrinding, RefusesAToolThatDoesNotFitBetweenThePlates)
{
  MadeWeld weld;
  weld.height = 0.8e-3;
  weld.slope_left = weld.slope_right = 1.0;
  weld.make();
  GrindingParams params;
  params.tool_width = 0.0081;
  const GrindingPlan plan = planGrinding(weld.scan, weld.result, params);
  EXPECT_TRUE(plan.passes.empty());
  EXPECT_NE(plan.reason.find("tool_width 8.1 mm is more than the face between the parents (8 mm)"), std::string::npos)
      << plan.reason;
  EXPECT_FALSE(plan.target.empty()) << "the surfaces are known all the same";
  params.tool_width = 0.0079;
  EXPECT_FALSE(planGrinding(weld.scan, weld.result, params).passes.empty());
}

TEST(FilletGrinding, LeavesOutWhereTheToolDoesNotFit)
{
  MadeWeld weld;
  weld.height = 0.8e-3;
  weld.slope_left = weld.slope_right = 1.0;
  weld.narrowing = 0.2;
  weld.make();
  GrindingParams params;
  params.tool_width = 0.008;
  const GrindingPlan plan = planGrinding(weld.scan, weld.result, params);
  ASSERT_FALSE(plan.passes.empty());
  EXPECT_NE(plan.reason.find("does not fit between the parents"), std::string::npos) << plan.reason;
  for (const GrindingPass& pass : plan.passes)
    for (const GrindingPoint& point : pass.points)
      EXPECT_LT(placeOf(weld, point.pose).x(), 0.1e-3) << "from there on it is narrower than the tool";
}

TEST(FilletGrinding, IsPlannedFromWhatIsMeasured)
{
  MadeWeld weld;
  weld.cells = 1440;
  weld.height = 0.8e-3;
  weld.slope_left = weld.slope_right = 1.0;
  weld.sigma = 8e-6;
  weld.make();
  const WeldResult result = WeldMeasurer().measure(weld.scan);
  ASSERT_EQ(result.kind, WeldKind::Fillet) << result.reason;
  const GrindingPlan plan = planGrinding(weld.scan, result);
  ASSERT_FALSE(plan.passes.empty()) << plan.reason;
  for (const GrindingPass& pass : plan.passes)
    for (const GrindingPoint& point : pass.points)
    {
      const Eigen::Vector2d place = placeOf(weld, point.pose);
      EXPECT_LE(std::abs(place.y()) + 0.5 * GrindingParams().tool_width, 0.5 * weld.width + 0.1e-3);
      const double level = (plan.layers - 1 - pass.layer) * GrindingParams().depth_per_pass;
      EXPECT_NEAR(point.pose.position.z(), weld.target(place.x(), place.y()) + level, 0.02e-3);
    }
}
