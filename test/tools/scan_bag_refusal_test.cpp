#include <filesystem>
#include <string>
#include <vector>

#include <sensor_msgs/Image.h>
#include <sensor_msgs/JointState.h>

#include "scan_bag_case.h"

namespace weld_profiler
{
namespace
{
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

/// The sections of a parameter file that a command reads, told by what it refuses in them, are those its help names.
TEST_F(ScanBagRefuses, WhatItsHelpSaysThatItReads)
{
  const std::vector<std::string> sections = { "camera",        "simulated_rig", "stage_encoder",
                                              "stripe_centre", "triangulation", "weld_measurement" };
  const std::vector<std::pair<std::string, std::string>> commands = {
    { "scan_bag", kCalibration + "--params strange.yaml --out out nowhere.bag" },
    { "extract_stripe", "--params strange.yaml --out out nowhere.png" }
  };
  int read = 0;
  for (const auto& [command, arguments] : commands)
  {
    const std::string help = run(command, "--help").output;
    const std::string about = help.substr(help.find("  --params FILE"), 300);
    const std::string sentence = about.substr(0, about.find("\n  --", 5));
    for (const std::string& section : sections)
    {
      write("strange.yaml", section + ":\n  strange: 1\n");
      const bool reads = run(command, arguments).says("strange.yaml: " + section);
      EXPECT_EQ(sentence.find(section) != std::string::npos, reads) << command << ", " << section << ": " << sentence;
      read += reads ? 1 : 0;
    }
  }
  EXPECT_EQ(read, 4);
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
  write("limits.yaml", "version: 1\n");
  write("params.yaml", "weld_measurement: {limits_file: limits.yaml}\n");
  refuses(kCalibration + "--params params.yaml --out out weld.bag", { "limits.yaml", "standard is missing" });
  write("params.yaml", "weld_measurement: {limits_file: nowhere.yaml}\n");
  refuses(kCalibration + "--params params.yaml --out out weld.bag", { "nowhere.yaml" });
  write("params.yaml", "weld_measurement: {thickness: -1}\n");
  refuses(kCalibration + "--params params.yaml --out out weld.bag", { "thickness", "-1" });
  refuses(kCalibration + "--weld-id N\xe4ht --out out weld.bag", { "id is no UTF-8" });
  write("params.yaml", "weld_measurement: {limits_file: \"N\xe4ht.yaml\"}\n");
  refuses(kCalibration + "--params params.yaml --out out weld.bag", { "params.yaml", "no UTF-8" });
  refuses(kCalibration + "--max-drop 2 --out out weld.bag", { "max-drop" });
  refuses(kCalibration + "--motion tf --out out weld.bag", { "fixed_frame" });
  refuses(kCalibration + "--out /dev/null/out weld.bag", { "/dev/null" });
  EXPECT_EQ(scan(kCalibration + "weld.bag").status, 2) << "no --out";
  EXPECT_EQ(scan(kCalibration + "--out out").status, 2) << "no bag";
}
}  // namespace
}  // namespace weld_profiler
