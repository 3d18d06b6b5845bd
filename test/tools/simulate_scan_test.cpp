#include "bag_contents.h"
#include "run_command_line.h"
#include "small_rig.h"

namespace weld_profiler
{
namespace
{
const std::string kScene = kSmallRig + "frame_count: 5\n";

class SimulateScan : public CommandTest
{
protected:
  void SetUp() override
  {
    CommandTest::SetUp();
    write("scene.yaml", kScene);
  }
  CommandResult simulate(const std::string& arguments, const std::string& setup = ":") const
  {
    return run("simulate_scan", arguments, setup);
  }
};

TEST_F(SimulateScan, WritesImagesCameraAndEncoderInTheOrderOfTheirStamps)
{
  const CommandResult result = simulate("--scene scene.yaml --out weld.bag");
  ASSERT_EQ(result.status, 0) << result.errors;
  EXPECT_EQ(result.errors, "") << "quiet in a pipe";
  const BagContents bag = readBag(path("weld.bag"));
  EXPECT_EQ(bag.topics.size(), 3u);
  EXPECT_EQ(bag.topics.count("/profiler/image_raw"), 1u);
  EXPECT_EQ(bag.topics.count("/profiler/camera_info"), 1u);
  EXPECT_TRUE(bag.times_are_stamps);
  ASSERT_EQ(bag.images.size(), 5u);
  ASSERT_EQ(bag.infos.size(), 5u);
  ASSERT_GT(bag.joints.size(), 40u);
  for (std::size_t i = 0; i < bag.images.size(); ++i)
  {
    EXPECT_EQ(bag.images[i]->width, 360u);
    EXPECT_EQ(bag.images[i]->header.stamp.toNSec(), 1000000000000u + i * 50000000u) << "20 frames a second";
    EXPECT_EQ(bag.infos[i]->header.stamp, bag.images[i]->header.stamp);
  }
  EXPECT_LT(bag.joints.front()->header.stamp, bag.images.front()->header.stamp);
  EXPECT_GT(bag.joints.back()->header.stamp, bag.images.back()->header.stamp);
  for (std::size_t i = 1; i < bag.joints.size(); ++i)
    ASSERT_LT(bag.joints[i - 1]->header.stamp, bag.joints[i]->header.stamp);
}

TEST_F(SimulateScan, TheTruthLiesBesideTheBag)
{
  ASSERT_EQ(simulate("--scene scene.yaml --out weld.bag").status, 0);
  EXPECT_EQ(filesIn("."), (std::vector<std::string>{ "scene.yaml", "weld.bag", "weld.bag.truth" }));
  std::istringstream lines(text("weld.bag.truth/centres.csv"));
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "frame,stamp,stage_m,cell,u_px,v_px,normal_rad,x_m,y_m,z_m,visible");
  int frame = -1;
  int rows = 0;
  for (; std::getline(lines, line); ++rows)
  {
    double stamp = 0.0;
    double stage = 0.0;
    unsigned cell = 0;
    ASSERT_EQ(std::sscanf(line.c_str(), "%d,%lf,%lf,%u", &frame, &stamp, &stage, &cell), 4) << line;
    EXPECT_NEAR(stamp, 1000.0 + 0.05 * frame, 1e-6);
    EXPECT_LT(cell, 360u);
  }
  EXPECT_EQ(frame, 4);
  EXPECT_GT(rows, 5 * 300);
}

TEST_F(SimulateScan, ItsOwnSceneFileGivesTheSameBytes)
{
  ASSERT_EQ(simulate("--scene scene.yaml --out one.bag").status, 0);
  ASSERT_EQ(simulate("--scene one.bag.truth/scene.yaml --out two.bag").status, 0);
  EXPECT_EQ(text("one.bag"), text("two.bag"));
  ASSERT_EQ(filesIn("one.bag.truth"), filesIn("two.bag.truth"));
  for (const std::string& name : filesIn("one.bag.truth"))
    EXPECT_EQ(text("one.bag.truth/" + name), text("two.bag.truth/" + name)) << name;
}

TEST_F(SimulateScan, ASensorOnARobotAlsoGivesTransforms)
{
  write("tf.yaml", kScene + "motion: tf\n");
  ASSERT_EQ(simulate("--scene tf.yaml --out weld.bag").status, 0);
  const BagContents bag = readBag(path("weld.bag"));
  ASSERT_GT(bag.transforms.size(), 20u);
  EXPECT_TRUE(bag.times_are_stamps);
  for (const auto& message : bag.transforms)
  {
    const auto& q = message->transforms.at(0).transform.rotation;
    EXPECT_NEAR(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w, 1.0, 1e-9);
    EXPECT_EQ(message->transforms.at(0).child_frame_id, "camera_optical_frame");
  }
}

TEST_F(SimulateScan, BadScenesAndOutputsAreOneLineAndLeaveNothing)
{
  write("typo.yaml", "frame_cuont: 3\n");
  write("range.yaml", "exposure: -1\n");
  const std::vector<std::string> bad = {
    "--scene none.yaml --out weld.bag",     "--scene typo.yaml --out weld.bag",
    "--scene range.yaml --out weld.bag",    "--preset nice --out weld.bag",
    "--scene scene.yaml --out no/weld.bag", "--scene scene.yaml --out /proc/weld.bag"
  };
  for (const std::string& arguments : bad)
  {
    const CommandResult result = simulate(arguments);
    EXPECT_EQ(result.status, 1) << arguments;
    EXPECT_EQ(result.errorLines(), 1) << arguments << ": " << result.errors;
  }
  const CommandResult full = simulate("--scene scene.yaml --out weld.bag", "ulimit -f 100");
  EXPECT_EQ(full.status, 1);
  EXPECT_EQ(full.errorLines(), 1) << full.errors;
  EXPECT_EQ(filesIn("."), (std::vector<std::string>{ "range.yaml", "scene.yaml", "typo.yaml" }));
}

TEST_F(SimulateScan, AnInterruptLeavesNothing)
{
  const std::string program = WELD_PROFILER_COMMANDS "/simulate_scan";
  const std::string line = "cd '" + folder_.string() + "' && { '" + program +
                           "' --preset harsh --out weld.bag 2> /dev/null & "
                           "until ls -A | grep -q partial.*bag; do sleep 0.05; done; kill -TERM $!; wait $!; }";
  const int status = std::system(line.c_str());
  EXPECT_EQ(WEXITSTATUS(status), 130);
  EXPECT_EQ(filesIn("."), (std::vector<std::string>{ "scene.yaml" }));
}

TEST_F(SimulateScan, UsageAndHelp)
{
  EXPECT_EQ(simulate("").status, 2);
  EXPECT_EQ(simulate("--preset harsh --scene scene.yaml --out weld.bag").status, 2);
  EXPECT_EQ(simulate("--help").status, 0);
}
}  // namespace
}  // namespace weld_profiler
