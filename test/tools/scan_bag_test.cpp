#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>

#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/JointState.h>
#include <yaml-cpp/yaml.h>

#include "bag_rewrite.h"
#include "run_command_line.h"

namespace weld_profiler
{
namespace
{
// the default rig at a quarter of its pixels, so that a frame takes a moment
const char* const kScene = R"(preset: realistic
frame_count: 20
encoder_rate: 200
laser: {sigma_px: 1.4, lens_sigma_px: 0.9}
camera:
  image_width: 360
  image_height: 270
  camera_matrix: [1500.0, 0.0, 179.5, 0.0, 1500.0, 134.5, 0.0, 0.0, 1.0]
  distortion_model: plumb_bob
  distortion_coefficients: [0.0, 0.0, 0.0, 0.0, 0.0]
)";
const std::string kCalibration = "--calibration weld.bag.truth/calibration.yaml ";

class ScanBag : public CommandTest
{
protected:
  void SetUp() override
  {
    CommandTest::SetUp();
    write("scene.yaml", kScene);
    ASSERT_EQ(run("simulate_scan", "--scene scene.yaml --out weld.bag").status, 0);
  }

  CommandResult scan(const std::string& arguments) const { return run("scan_bag", arguments); }

  YAML::Node summary(const std::string& directory) const { return YAML::LoadFile(path(directory + "/summary.json")); }

  /// weld.bag with every message through change, which may leave it out by returning false.
  template <class Message>
  void rewrite(const std::string& target, const std::function<bool(std::size_t, Message&)>& change) const
  {
    rewriteBag<Message>(path("weld.bag"), path(target), change);
  }

  /// frames_in = rows + no_stripe + skipped + unplaced + dropped.
  static void expectClosed(const YAML::Node& summary)
  {
    std::uint64_t sum = summary["rows"].as<std::uint64_t>() + summary["no_stripe"].as<std::uint64_t>() +
                        summary["skipped"].as<std::uint64_t>();
    for (const char* key : { "unplaced", "dropped" })
    {
      for (const auto& reason : summary[key])
        sum += reason.second.as<std::uint64_t>();
    }
    EXPECT_EQ(sum, summary["frames_in"].as<std::uint64_t>());
  }
};

/// What a bag with one scan of a weld leaves; where a scan as coarse as this one shows no section there are no meshes.
std::vector<std::string> weldFiles(bool meshes)
{
  std::vector<std::string> names = { "passes.csv", "report.html", "report.png",     "scan.pcd",
                                     "scan.ply",   "spots.csv",   "summary.json",   "verdict.csv",
                                     "weld.csv",   "weld.json",   "weld_points.pcd" };
  if (meshes)
    names.insert(names.end(), { "bead.ply", "target.ply" });
  std::sort(names.begin(), names.end());
  return names;
}

TEST_F(ScanBag, LeavesCloudAndBalance)
{
  const CommandResult result = scan(kCalibration + "--out scan weld.bag");
  ASSERT_EQ(result.status, 0) << result.errors;
  EXPECT_EQ(filesIn("scan"), weldFiles(std::filesystem::exists(path("scan/bead.ply"))));
  const YAML::Node balance = summary("scan");
  EXPECT_EQ(balance["frames_in"].as<int>(), 20);
  EXPECT_EQ(balance["rows"].as<int>(), 20);
  expectClosed(balance);
  const std::string pcd = text("scan/scan.pcd");
  EXPECT_NE(pcd.find("WIDTH 360"), std::string::npos);
  EXPECT_NE(pcd.find("HEIGHT 20"), std::string::npos);
  EXPECT_NE(pcd.find("DATA binary\n"), std::string::npos);
}

TEST_F(ScanBag, AGapOfTheEncoderLeavesItsFramesUnplacedAndCounted)
{
  rewrite<sensor_msgs::JointState>(
      "gap.bag", [](std::size_t, sensor_msgs::JointState& joints)
      { return joints.header.stamp < ros::Time(1000.2) || joints.header.stamp > ros::Time(1000.4); });
  const CommandResult result = scan(kCalibration + "--max-drop 1 --out scan gap.bag");
  EXPECT_EQ(result.status, 0) << result.errors;
  const YAML::Node balance = summary("scan");
  EXPECT_GE(balance["unplaced"]["encoder_gap"].as<int>(), 3);
  expectClosed(balance);
  EXPECT_EQ(scan(kCalibration + "--out scan gap.bag").status, 3) << "a fifth of the frames is lost: poor, and said so";
}

TEST_F(ScanBag, ANaNOfTheEncoderPlacesNothing)
{
  rewrite<sensor_msgs::JointState>("nan.bag",
                                   [](std::size_t index, sensor_msgs::JointState& joints)
                                   {
                                     if (index % 2 == 0)
                                       joints.position[0] = std::numeric_limits<double>::quiet_NaN();
                                     return true;
                                   });
  EXPECT_EQ(scan(kCalibration + "--out scan nan.bag").status, 3);
  const YAML::Node balance = summary("scan");
  EXPECT_EQ(balance["rows"].as<int>(), 0);
  EXPECT_EQ(balance["unplaced"]["encoder_not_finite"].as<int>(), 20);
  expectClosed(balance);
}

TEST_F(ScanBag, ADarkFrameIsARowOfNaN)
{
  rewrite<sensor_msgs::Image>("dark.bag",
                              [](std::size_t index, sensor_msgs::Image& image)
                              {
                                if (index == 7)
                                  std::fill(image.data.begin(), image.data.end(), 5);
                                return true;
                              });
  ASSERT_EQ(scan(kCalibration + "--out scan dark.bag").status, 0);
  const YAML::Node balance = summary("scan");
  EXPECT_EQ(balance["no_stripe"].as<int>(), 1);
  EXPECT_EQ(balance["rows"].as<int>(), 19);
  expectClosed(balance);
  EXPECT_NE(text("scan/scan.pcd").find("HEIGHT 20"), std::string::npos);
}

TEST_F(ScanBag, ImagesThatDoNotFitAreDroppedAndSaidOnce)
{
  rewrite<sensor_msgs::Image>("small.bag",
                              [](std::size_t index, sensor_msgs::Image& image)
                              {
                                if (index == 3)
                                  image.data.resize(10);
                                if (index == 4 || index == 5)
                                {
                                  image.height = 100;
                                  image.data.resize(image.step * 100);
                                }
                                return true;
                              });
  const CommandResult result = scan(kCalibration + "--max-drop 0.2 --out scan small.bag");
  EXPECT_EQ(result.status, 0) << result.errors;
  const YAML::Node balance = summary("scan");
  EXPECT_EQ(balance["dropped"]["bad_image"].as<int>(), 1);
  EXPECT_EQ(balance["dropped"]["image_size"].as<int>(), 2);
  expectClosed(balance);
  EXPECT_TRUE(result.says("image is 360 x 100")) << result.errors;
}

TEST_F(ScanBag, AnAllZeroCameraInfoIsRefused)
{
  rewrite<sensor_msgs::CameraInfo>("zero.bag",
                                   [](std::size_t, sensor_msgs::CameraInfo& info)
                                   {
                                     const std_msgs::Header header = info.header;
                                     info = sensor_msgs::CameraInfo();
                                     info.header = header;
                                     return true;
                                   });
  EXPECT_EQ(scan(kCalibration + "--out scan zero.bag").status, 3);
  EXPECT_EQ(summary("scan")["dropped"]["camera_info"].as<int>(), 20);
}

TEST_F(ScanBag, LeavesNoCloudOfAnEarlierRunBesideItsSummary)
{
  write("short.yaml", "triangulation: {max_rows: 8}\n");
  ASSERT_EQ(scan(kCalibration + "--no-weld --params short.yaml --out scan weld.bag").status, 0);
  EXPECT_EQ(filesIn("scan").size(), 7u) << "three scans of at most 8 rows";
  ASSERT_EQ(scan(kCalibration + "--no-weld --out scan weld.bag").status, 0);
  EXPECT_EQ(filesIn("scan"), (std::vector<std::string>{ "scan.pcd", "scan.ply", "summary.json" }));
}

TEST_F(ScanBag, AWindowThatCutsEveryPointIsAPoorResult)
{
  write("window.yaml", "triangulation: {min_z: 1.0, max_z: 2.0}\n");
  const CommandResult result = scan(kCalibration + "--params window.yaml --out scan weld.bag");
  EXPECT_EQ(result.status, 3);
  EXPECT_TRUE(result.says("window")) << result.errors;
}

TEST_F(ScanBag, AnEncoderSampleThatComesLateClosesNoScan)
{
  rewrite<sensor_msgs::JointState>("late.bag",
                                   [](std::size_t index, sensor_msgs::JointState& joints)
                                   {
                                     if (index % 50 == 49)
                                     {
                                       joints.header.stamp -= ros::Duration(0.0101);
                                       joints.position[0] -= 0.0101 * 0.005;
                                     }
                                     return true;
                                   });
  ASSERT_EQ(scan(kCalibration + "--out scan late.bag").status, 0);
  EXPECT_EQ(summary("scan")["rows"].as<int>(), 20);
  EXPECT_EQ(summary("scan")["scans"].as<int>(), 1);
}

TEST_F(ScanBag, ACalibrationOfAnotherCameraIsRefusedFrameByFrame)
{
  std::string calibration = text("weld.bag.truth/calibration.yaml");
  calibration.replace(calibration.find("1500"), 4, "1501");
  write("other.yaml", calibration);
  const CommandResult result = scan("--calibration other.yaml --out scan weld.bag");
  EXPECT_EQ(result.status, 3) << result.errors;
  EXPECT_TRUE(result.says("camera_info K[0] is 1500")) << result.errors;
  EXPECT_EQ(summary("scan")["dropped"]["camera_info"].as<int>(), 20);
}

/// One line on standard error, exit status 1, nothing left behind.
class ScanBagRefuses : public ScanBag
{
protected:
  void refuses(const std::string& arguments, const std::vector<std::string>& words)
  {
    const CommandResult result = scan(arguments);
    EXPECT_EQ(result.status, 1) << arguments;
    EXPECT_EQ(result.errorLines(), 1) << result.errors;
    for (const std::string& word : words)
      EXPECT_TRUE(result.says(word)) << "no '" << word << "' in: " << result.errors;
    EXPECT_FALSE(std::filesystem::exists(path("out"))) << arguments;
  }
};

TEST_F(ScanBagRefuses, ABagThatIsNoneOrDamaged)
{
  refuses(kCalibration + "--out out nowhere.bag", { "nowhere.bag" });
  write("text.bag", "this is no bag\n");
  refuses(kCalibration + "--out out text.bag", { "text.bag" });
  const std::string whole = text("weld.bag");
  write("cut.bag", whole.substr(0, whole.size() / 2));
  refuses(kCalibration + "--out out cut.bag", { "cut.bag", "rosbag reindex" });
}

TEST_F(ScanBagRefuses, ABagWithoutTheTopics)
{
  rewrite<sensor_msgs::JointState>("no_encoder.bag", [](std::size_t, sensor_msgs::JointState&) { return false; });
  refuses(kCalibration + "--out out no_encoder.bag", { "no_encoder.bag", "/profiler/joint_states" });
  rewrite<sensor_msgs::Image>("no_images.bag", [](std::size_t, sensor_msgs::Image&) { return false; });
  refuses(kCalibration + "--out out no_images.bag", { "no_images.bag", "image_raw" });
  refuses(kCalibration + "--namespace /other --out out weld.bag", { "/other/image_raw", "/profiler/" });
}

TEST_F(ScanBagRefuses, AJointThatIsNotThere)
{
  rewrite<sensor_msgs::JointState>("other_joint.bag",
                                   [](std::size_t, sensor_msgs::JointState& joints)
                                   {
                                     joints.name[0] = "gripper";
                                     return true;
                                   });
  refuses(kCalibration + "--out out other_joint.bag", { "stage_joint", "gripper" });
}

TEST_F(ScanBagRefuses, BadParametersAndPlaces)
{
  refuses("--calibration nowhere.yaml --out out weld.bag", { "nowhere.yaml" });
  write("params.yaml", "stripe_centre: {method: gray_center}\n");
  refuses(kCalibration + "--params params.yaml --out out weld.bag", { "gray_center", "gray_centroid" });
  write("params.yaml", "stripe_centre: {min_peak_count: 3}\n");
  refuses(kCalibration + "--params params.yaml --out out weld.bag", { "min_peak_count" });
  write("params.yaml", "triangulation: {max_encoder_gap: .nan}\n");
  refuses(kCalibration + "--params params.yaml --out out weld.bag", { "max_encoder_gap", "nan" });
  refuses(kCalibration + "--max-drop 2 --out out weld.bag", { "max-drop" });
  refuses(kCalibration + "--motion tf --out out weld.bag", { "fixed_frame" });
  refuses(kCalibration + "--out /dev/null/out weld.bag", { "/dev/null" });
  EXPECT_EQ(scan(kCalibration + "weld.bag").status, 2) << "no --out";
  EXPECT_EQ(scan(kCalibration + "--out out").status, 2) << "no bag";
}
}  // namespace
}  // namespace weld_profiler
