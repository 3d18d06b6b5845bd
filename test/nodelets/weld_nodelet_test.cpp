// The whole chain with the weld at its end, in one manager: live sections, the summary, what grinding takes, the
// action.
#include <filesystem>
#include <fstream>

#include <actionlib/client/simple_action_client.h>
#include <geometry_msgs/PoseArray.h>
#include <gtest/gtest.h>
#include <pcl_msgs/PolygonMesh.h>
#include <sensor_msgs/PointCloud2.h>
#include <std_srvs/Trigger.h>
#include <visualization_msgs/MarkerArray.h>

#include "nodelets/weld_chain.h"
#include "support/collector.h"
#include "weld_profiler/GrindingPasses.h"
#include "weld_profiler/ScanWeldAction.h"
#include "weld_profiler/WeldMeasurement.h"

namespace weld_profiler
{
namespace
{
using Client = actionlib::SimpleActionClient<ScanWeldAction>;

std::size_t fieldCount(const sensor_msgs::PointCloud2& cloud, const std::string& name)
{
  std::size_t count = 0;
  for (const sensor_msgs::PointField& field : cloud.fields)
    count += field.name == name ? 1 : 0;
  return count;
}

/// With a width, as they came.
std::vector<WeldCrossSection> liveSections(const Collector<WeldMeasurement>& measured)
{
  std::vector<WeldCrossSection> sections;
  for (const auto& message : measured.all())
    if (message->type == WeldMeasurement::LIVE && message->sections.size() == 1 &&
        std::isfinite(message->sections[0].width.value))
      sections.push_back(message->sections[0]);
  return sections;
}

/// The chain's weld, 10 mm wide, plates 0.3 mm apart in height.
void expectTheWeld(const WeldMeasurement& summary)
{
  EXPECT_EQ(summary.kind, "butt") << summary.reason;
  ASSERT_GT(summary.sections.size(), 40U);
  EXPECT_GT(summary.measured_share, 0.9F);
  EXPECT_FALSE(summary.calibration_hash.empty());
  EXPECT_NE(summary.settings.find("thickness: 0.008"), std::string::npos) << summary.settings;
  EXPECT_FALSE(summary.verdict.empty());
  const WeldCrossSection& middle = summary.sections[summary.sections.size() / 2];
  EXPECT_NEAR(middle.width.value, 0.010, 0.0001);
  EXPECT_NEAR(middle.misalignment.value, 0.0003, 0.00003);
}

void expectLabelled(const sensor_msgs::PointCloud2& cloud)
{
  EXPECT_EQ(cloud.point_step, 40U);
  EXPECT_EQ(cloud.data.size(), static_cast<std::size_t>(cloud.width) * cloud.height * 40U);
  EXPECT_EQ(fieldCount(cloud, "label"), 1U);
  EXPECT_EQ(fieldCount(cloud, "removal"), 1U);
}

TEST(WeldNodelet, MeasuresAScanThatEndsAndHandsItToTheGrinder)
{
  WeldChain chain("/weld_scan");
  chain.manager.set("weld_measurement", "thickness", 0.008);
  chain.loadAll();
  const Collector<WeldMeasurement> measured(chain.manager.topic("weld"));
  const Collector<WeldMeasurement> summaries(chain.manager.topic("weld_summary"));
  const Collector<sensor_msgs::PointCloud2> points(chain.manager.topic("weld_points"));
  const Collector<GrindingPasses> passes(chain.manager.topic("grinding_passes"));
  const Collector<geometry_msgs::PoseArray> toes(chain.manager.topic("toe_left"));
  const Collector<pcl_msgs::PolygonMesh> beads(chain.manager.topic("bead_mesh"));
  const Collector<visualization_msgs::MarkerArray> markers(chain.manager.topic("weld_markers"));
  chain.feedAll();
  ASSERT_TRUE(waitFor([&] { return measured.size() >= kFrames - 1; })) << measured.size() << " live sections";
  ASSERT_TRUE(chain.call<std_srvs::Trigger>("stop_scan").success);
  ASSERT_TRUE(waitFor([&] { return summaries.size() == 1 && passes.size() == 1 && beads.size() == 1; }));

  const std::vector<WeldCrossSection> live = liveSections(measured);
  ASSERT_GT(live.size(), 0.8 * kFrames);
  int provisional = 0;
  for (const WeldCrossSection& section : live)
    provisional += std::abs(section.width.value - 0.010) < 0.0005 ? 1 : 0;
  EXPECT_GT(provisional, 0.8 * kFrames) << "live widths within 0.5 mm of 10 mm";

  expectTheWeld(*summaries.all().back());
  expectLabelled(*points.all().back());
  EXPECT_GT(toes.all().back()->poses.size(), 5U);
  EXPECT_GT(passes.all().back()->passes.size(), 1U) << passes.all().back()->reason;
  EXPECT_GT(passes.all().back()->removal_volume, 1e-8);
  EXPECT_GT(beads.all().back()->polygons.size(), 500U);
  EXPECT_GT(markers.all().back()->markers.size(), 2U);
  const std::string welds = chain.folder.file("welds");
  ASSERT_TRUE(waitFor([&] { return std::filesystem::exists(welds); }));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(welds), {}), 1);
}

TEST(WeldNodelet, TellsTheYawOfARunningScanFromItsOwnRows)
{
  const double yaw = 12.0 * M_PI / 180.0;
  WeldChain chain("/weld_yaw", yaw);
  chain.loadAll();
  const Collector<WeldMeasurement> measured(chain.manager.topic("weld"));
  chain.feedAll();
  ASSERT_TRUE(waitFor([&] { return measured.size() >= kFrames - 1; })) << measured.size() << " live sections";
  const std::vector<WeldCrossSection> live = liveSections(measured);
  ASSERT_GT(live.size(), 0.8 * kFrames);
  EXPECT_GT(live.front().yaw_sigma, 0.3) << "nothing is known at first";
  EXPECT_LT(live.back().yaw_sigma, 0.03);
  EXPECT_NEAR(live.back().yaw, yaw, 3.0 * live.back().yaw_sigma);
  for (const WeldCrossSection& section : live)
    EXPECT_LT(std::abs(section.width.value - 0.010), 5.0 * section.width.sigma) << section.stage;
}

TEST(WeldNodelet, GivesNothingToTheGrinderInAFrameThatIsNotThere)
{
  WeldChain chain("/weld_frame");
  chain.manager.set("weld_measurement", "output_frame", std::string("robot_base"));
  chain.loadAll();
  const Collector<WeldMeasurement> summaries(chain.manager.topic("weld_summary"));
  const Collector<GrindingPasses> passes(chain.manager.topic("grinding_passes"));
  const Collector<sensor_msgs::PointCloud2> points(chain.manager.topic("weld_points"));
  chain.feedAll();
  ASSERT_TRUE(chain.call<std_srvs::Trigger>("stop_scan").success);
  ASSERT_TRUE(waitFor([&] { return summaries.size() == 1; }));
  EXPECT_TRUE(waitFor([&] { return std::filesystem::exists(chain.folder.file("welds")); }));
  EXPECT_EQ(passes.size(), 0U);
  EXPECT_EQ(points.size(), 0U);
}

/// What the action says of the chain's weld. @param profiles  the most that its feedback told, if asked for.
ScanWeldResult scannedWeld(WeldChain& chain, const ScanWeldGoal& goal, std::uint32_t* profiles = nullptr)
{
  Client client(chain.manager.topic("scan_weld"), true);
  EXPECT_TRUE(client.waitForServer(ros::Duration(10.0)));
  client.sendGoal(goal, Client::SimpleDoneCallback(), Client::SimpleActiveCallback(),
                  [&](const ScanWeldFeedbackConstPtr& feedback)
                  {
                    if (profiles != nullptr)
                      *profiles = std::max(*profiles, feedback->profiles);
                  });
  EXPECT_TRUE(waitFor([&] { return client.getState() == actionlib::SimpleClientGoalState::ACTIVE; }));
  ros::WallDuration(0.5).sleep();
  chain.feedAll();
  EXPECT_TRUE(client.waitForResult(ros::Duration(30.0)));
  EXPECT_EQ(client.getState().toString(), "SUCCEEDED");
  return client.getResult() ? *client.getResult() : ScanWeldResult();
}

TEST(WeldNodelet, AScanIsAskedForByAnAction)
{
  WeldChain chain("/weld_action");
  chain.manager.set("triangulation", "auto_start", false);
  chain.manager.set("weld_measurement", "level", std::string("B"));
  const std::filesystem::path welds = chain.folder.file("welds");
  std::filesystem::create_directories(welds / "seam-12" / "scan_2");
  for (const char* name : { "scan.pcd", "scan.ply", "summary.json", "notes.txt", "scan_2/weld.json" })
    std::ofstream(welds / "seam-12" / name) << "of an earlier scan";
  chain.loadAll();
  ScanWeldGoal goal;
  goal.weld_id = "seam-12";
  goal.thickness = 0.008;
  std::uint32_t profiles = 0;
  const ScanWeldResult result = scannedWeld(chain, goal, &profiles);
  EXPECT_EQ(result.summary.weld_id, "seam-12");
  EXPECT_EQ(result.summary.kind, "butt") << result.message;
  EXPECT_NE(result.summary.verdict, "B") << result.message;
  EXPECT_FALSE(result.success) << "the level that the nodelet's parameters ask for is not met";
  EXPECT_GE(profiles, 30U);
  ASSERT_GE(result.files.size(), 5U) << result.message;
  for (const std::string& file : result.files)
  {
    EXPECT_TRUE(std::filesystem::exists(file)) << file;
    EXPECT_NE(file.find("seam-12"), std::string::npos) << file;
  }
  for (const char* name : { "scan.pcd", "scan.ply", "summary.json", "scan_2" })
    EXPECT_FALSE(std::filesystem::exists(welds / "seam-12" / name)) << name << " is of another scan";
  EXPECT_TRUE(std::filesystem::exists(welds / "seam-12" / "notes.txt"));
}

TEST(WeldNodelet, WithoutAThicknessAnActionTellsThatNotAllWasJudged)
{
  WeldChain chain("/weld_part");
  chain.manager.set("triangulation", "auto_start", false);
  chain.loadAll();
  ScanWeldGoal goal;
  goal.level = "D";
  const ScanWeldResult result = scannedWeld(chain, goal);
  EXPECT_NE(result.message.find("not fully judged, "), std::string::npos) << result.message;
  EXPECT_NE(result.message.find("no plate thickness given, not judged: undercut"), std::string::npos);
  EXPECT_FALSE(result.success) << "nobody knows whether level D is met";
  EXPECT_EQ(result.summary.lacks_thickness,
            (std::vector<std::string>{ "undercut", "misalignment", "incomplete_fill", "surface_pore" }));
}

TEST(WeldNodelet, ABadGoalIsRefusedByName)
{
  WeldChain chain("/weld_goal");
  chain.loadAll();
  Client client(chain.manager.topic("scan_weld"), true);
  ASSERT_TRUE(client.waitForServer(ros::Duration(10.0)));
  const auto refusal = [&](const ScanWeldGoal& goal)
  {
    client.sendGoal(goal);
    EXPECT_TRUE(client.waitForResult(ros::Duration(10.0)));
    EXPECT_EQ(client.getState().toString(), "ABORTED");
    return client.getResult()->message;
  };
  ScanWeldGoal goal;
  goal.weld_id = "../../etc";
  EXPECT_NE(refusal(goal).find("weld_id is '../../etc'"), std::string::npos);
  goal.weld_id = "N\xe4ht";
  EXPECT_NE(refusal(goal).find("no UTF-8"), std::string::npos);
  goal = ScanWeldGoal();
  goal.kind = "lap";
  EXPECT_NE(refusal(goal).find("'lap'"), std::string::npos);
  goal = ScanWeldGoal();
  goal.travel = -1.0;
  EXPECT_NE(refusal(goal).find("travel"), std::string::npos);
}
}  // namespace
}  // namespace weld_profiler

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "weld_nodelet_test");
  ros::NodeHandle keep_alive;
  return RUN_ALL_TESTS();
}
