#include <algorithm>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/JointState.h>

#include "scan_bag_case.h"

namespace weld_profiler
{
namespace
{
/// What a bag with one scan of a weld leaves.
const std::vector<std::string> kWeldFiles = { "bead.ply", "passes.csv", "report.html",    "report.png", "scan.pcd",
                                              "scan.ply", "spots.csv",  "summary.json",   "target.ply", "verdict.csv",
                                              "weld.csv", "weld.json",  "weld_points.pcd" };

/// Half of the default rig's pixels, and a weld that runs all along: every section shows it, as not every one of
/// weld.bag does.
const std::string kFineScene = R"(preset: realistic
encoder_rate: 200
frame_count: 20
weld: {start: -0.01}
camera:
  image_width: 720
  image_height: 540
  camera_matrix: [3000.0, 0.0, 359.5, 0.0, 3000.0, 269.5, 0.0, 0.0, 1.0]
  distortion_model: plumb_bob
  distortion_coefficients: [0.0, 0.0, 0.0, 0.0, 0.0]
)";

TEST_F(ScanBag, LeavesCloudAndBalance)
{
  const CommandResult result = scan(kCalibration + "--no-weld --out scan weld.bag");
  ASSERT_EQ(result.status, 0) << result.errors;
  EXPECT_EQ(filesIn("scan"), (std::vector<std::string>{ "scan.pcd", "scan.ply", "summary.json" }));
  const YAML::Node balance = summary("scan");
  EXPECT_EQ(balance["frames_in"].as<int>(), 20);
  EXPECT_EQ(balance["rows"].as<int>(), 20);
  expectClosed(balance);
  const std::string pcd = text("scan/scan.pcd");
  EXPECT_NE(pcd.find("WIDTH 360"), std::string::npos);
  EXPECT_NE(pcd.find("HEIGHT 20"), std::string::npos);
  EXPECT_NE(pcd.find("DATA binary\n"), std::string::npos);
}

TEST_F(ScanBag, LeavesEveryFileOfAWeldThatItMeasured)
{
  write("fine.yaml", kFineScene);
  ASSERT_EQ(run("simulate_scan", "--scene fine.yaml --out weld.bag").status, 0);
  const CommandResult result = scan(kCalibration + "--out scan weld.bag");
  ASSERT_EQ(result.status, 0) << result.errors;
  EXPECT_EQ(filesIn("scan"), kWeldFiles);
  EXPECT_TRUE(result.says("verdict: not fully judged, ")) << result.errors;
  EXPECT_TRUE(result.says(" by what was judged (no plate thickness given, not judged: undercut")) << result.errors;
  for (const char* mesh : { "scan/bead.ply", "scan/target.ply" })
  {
    const std::string ply = text(mesh);
    const std::size_t faces = ply.find("element face ");
    ASSERT_NE(faces, std::string::npos) << mesh;
    EXPECT_GT(std::stoi(ply.substr(faces + 13)), 1000) << mesh;
  }
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

TEST_F(ScanBag, LeavesNothingOfAnEarlierWeldBesideAnotherScan)
{
  ASSERT_EQ(scan(kCalibration + "--out scan weld.bag").status, 0);
  ASSERT_EQ(filesIn("scan"), kWeldFiles);
  std::filesystem::create_directory(path("scan/scan"));
  write("scan/scan/weld.json", "somebody's");
  std::filesystem::create_directory(path("scan/scan_2"));
  write("scan/scan_2/weld.json", "of a second scan");
  ASSERT_EQ(scan(kCalibration + "--no-weld --out scan weld.bag").status, 0);
  EXPECT_EQ(filesIn("scan"), (std::vector<std::string>{ "scan", "scan.pcd", "scan.ply", "summary.json" }));
  EXPECT_EQ(filesIn("scan/scan").size(), 1u);

  write("scan/report.html", "of an earlier weld");
  write("scan/report.png", "of an earlier weld");
  ASSERT_EQ(scan(kCalibration + "--no-report --out scan weld.bag").status, 0);
  EXPECT_TRUE(std::filesystem::exists(path("scan/weld.json")));
  EXPECT_FALSE(std::filesystem::exists(path("scan/report.html")));
  EXPECT_FALSE(std::filesystem::exists(path("scan/report.png")));

  write("short.yaml", "triangulation: {max_rows: 12}\n");
  std::filesystem::create_directory(path("scan/scan_2"));
  write("scan/scan_2/weld.json", "of an earlier run");
  ASSERT_EQ(scan(kCalibration + "--no-weld --params short.yaml --out scan weld.bag").status, 0);
  EXPECT_TRUE(std::filesystem::exists(path("scan/scan_2.pcd")));
  EXPECT_FALSE(std::filesystem::exists(path("scan/scan_2/weld.json")));
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
}  // namespace
}  // namespace weld_profiler
