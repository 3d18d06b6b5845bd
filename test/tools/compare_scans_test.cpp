#include <yaml-cpp/yaml.h>

#include "run_command_line.h"
#include "weld/ground_weld.h"
#include "weld_profiler/scan/export.h"
#include "weld_profiler/scan/scan_file.h"

namespace weld_profiler
{
namespace
{
constexpr double kLength = 59 * 2e-4;  // of the scan before, first row to last

class CompareScans : public CommandTest
{
protected:
  void SetUp() override
  {
    CommandTest::SetUp();
    IdealWeld weld;
    save(IdealScanner()(weld), "before.pcd");
    weld.height = 0.0003;
    const Dip dip{ 0.009, 0.006, 0.001, 1.2e-4 };
    const auto ground = [&](double x, double y) { return weld(x, y) - dip(x, y); };
    save(moved(longerScanner(5)(ground), motionAbout({ 0, 0.006, 0 }, { 2e-4, 0, 1e-3 }, { 1, -1, 0.3 })), "after.pcd");
  }

  void save(const Scan& scan, const std::string& name) const { saveScan(scan, path(name), "pcd"); }
  CommandResult compare(const std::string& arguments) const { return run("compare_scans", arguments); }
  YAML::Node record(const std::string& folder) const { return YAML::LoadFile(path(folder + "/compare.json")); }

  /// The folder NAME from the scene NAME.yaml.
  void simulateAndScan(const std::string& name) const
  {
    ASSERT_EQ(run("simulate_scan", "--scene " + name + ".yaml --out " + name + ".bag").status, 0);
    const CommandResult result = run("scan_bag", "--no-report --weld-id seam --calibration " + name +
                                                     ".bag.truth/calibration.yaml --out " + name + " " + name + ".bag");
    ASSERT_EQ(result.status, 0) << result.errors;
  }

  void refuses(const std::string& arguments, const std::vector<std::string>& words, int status = 1) const
  {
    const CommandResult result = compare("--no-report --out out " + arguments);
    EXPECT_EQ(result.status, status) << arguments;
    EXPECT_EQ(result.errorLines(), 1) << result.errors;
    for (const std::string& word : words)
      EXPECT_TRUE(result.says(word)) << "no '" << word << "' in: " << result.errors;
    EXPECT_FALSE(std::filesystem::exists(path("out"))) << arguments;
  }
};

TEST_F(CompareScans, LeavesRecordMapsAndReport)
{
  const CommandResult result = compare("--weld-id K-17 --out ground before.pcd after.pcd");
  ASSERT_EQ(result.status, 0) << result.errors;
  EXPECT_EQ(filesIn("ground"),
            (std::vector<std::string>{ "compare.json", "difference.pcd", "report.html", "report.png" }));
  const YAML::Node json = record("ground");
  EXPECT_EQ(json["id"].as<std::string>(), "K-17");
  EXPECT_EQ(json["before"].as<std::string>(), "before.pcd");
  EXPECT_EQ(json["kind"].as<std::string>(), "bead_on_plate");
  const double left = segmentArea(0.008, 0.0003) * kLength, whole = segmentArea(0.008, 0.0015) * kLength;
  const YAML::Node removed = json["removed_volume"], remaining = json["remaining_volume"];
  EXPECT_LT(std::abs(removed["value"].as<double>() - (whole - left)), 3.0 * removed["sigma"].as<double>());
  EXPECT_LT(std::abs(remaining["value"].as<double>() - left), 3.0 * remaining["sigma"].as<double>());
  ASSERT_EQ(json["over_ground"].size(), 1u);
  EXPECT_NEAR(json["over_ground"][0]["depth"]["value"].as<double>(), 1.2e-4, 6e-6);
  EXPECT_NEAR(json["over_ground"][0]["x"].as<double>(), 0.009, 0.0012);
  EXPECT_DOUBLE_EQ(json["over_ground_limit"].as<double>(), 5e-5);
  EXPECT_GT(json["measured_share"].as<double>(), 0.99);
  EXPECT_NEAR(json["aligned"]["shift"][2].as<double>(), -1e-3, 1e-4);
  EXPECT_LT(json["aligned"]["residual"].as<double>(), 5e-6);
  EXPECT_EQ(json["aligned"]["before_T_after"].size(), 12u);
  EXPECT_DOUBLE_EQ(json["settings"]["placement"].as<double>(), 5e-4);
  EXPECT_NE(text("ground/difference.pcd").find("FIELDS x y z after removed remaining spot"), std::string::npos);
  const Scan map = loadScan(path("ground/difference.pcd"));
  EXPECT_EQ(map.cells, 1000u);
  EXPECT_EQ(map.rows.size(), 60u);
  EXPECT_EQ(map.rows[0].points.size(), 1000u);
  EXPECT_NE(text("ground/report.html").find("OVER-GROUND"), std::string::npos);
  EXPECT_NE(text("ground/report.html").find(path("ground")), std::string::npos) << "where the files lie";
  EXPECT_TRUE(result.says("1 over-ground place")) << result.errors;
}

TEST_F(CompareScans, TheSameScansGiveTheSameBytes)
{
  ASSERT_EQ(compare("--no-report --out one before.pcd after.pcd").status, 0);
  ASSERT_EQ(compare("--no-report --out two before.pcd after.pcd").status, 0);
  EXPECT_EQ(filesIn("one"), (std::vector<std::string>{ "compare.json", "difference.pcd" }));
  EXPECT_EQ(text("one/compare.json"), text("two/compare.json"));
  EXPECT_EQ(text("one/difference.pcd"), text("two/difference.pcd"));
}

TEST_F(CompareScans, ReplacesAnEarlierComparisonAndNothingElse)
{
  ASSERT_EQ(compare("--out ground before.pcd after.pcd").status, 0);
  write("ground/notes.txt", "mine");
  ASSERT_EQ(compare("--no-report --threshold 0.2 --out ground before.pcd after.pcd").status, 0);
  EXPECT_EQ(filesIn("ground"), (std::vector<std::string>{ "compare.json", "difference.pcd", "notes.txt" }))
      << "the report was that of the earlier one";
  EXPECT_EQ(record("ground")["over_ground"].size(), 0u) << "0.12 mm is not deeper than 0.2 mm";
  const std::string before = text("ground/compare.json");
  EXPECT_EQ(compare("--no-report --out ground after.pcd nowhere.pcd").status, 1);
  EXPECT_EQ(text("ground/compare.json"), before) << "a failed run leaves the earlier one as it was";
  EXPECT_EQ(filesIn("ground").size(), 3u);
}

TEST_F(CompareScans, MeasuresAsTheFolderSaysOrTheParameters)
{
  std::filesystem::create_directory(path("scan"));
  std::filesystem::copy_file(path("before.pcd"), path("scan/scan.pcd"));
  write("scan/weld.json", R"({"id": "seam 4", "frame_id": "scan", "kind": "butt",
    "settings": {"kind": "butt", "target": "rest", "rest_height": 0.0003},
    "calibration": {"file": "c.yaml", "hash": "00ff"}})");
  ASSERT_EQ(compare("--no-report --out ground scan after.pcd").status, 0);
  const YAML::Node json = record("ground");
  EXPECT_EQ(json["id"].as<std::string>(), "seam 4");
  EXPECT_EQ(json["kind"].as<std::string>(), "butt");
  EXPECT_EQ(json["settings"]["target"].as<std::string>(), "rest");
  EXPECT_EQ(json["calibration"]["hash"].as<std::string>(), "00ff");
  EXPECT_LT(json["remaining_volume"]["value"].as<double>(), 1e-9) << "less is left above a rest of 0.3 mm";
  write("params.yaml", "weld_measurement: {kind: bead_on_plate, output: somewhere}\n");
  ASSERT_EQ(compare("--no-report --params params.yaml --out ground scan after.pcd").status, 0);
  EXPECT_EQ(record("ground")["kind"].as<std::string>(), "bead_on_plate");
  EXPECT_EQ(record("ground")["settings"]["target"].as<std::string>(), "flush");
  std::filesystem::rename(path("scan/scan.pcd"), path("scan/weld_points.pcd"));
  EXPECT_EQ(compare("--no-report --out ground scan after.pcd").status, 0) << "what the action scan_weld leaves";
}

TEST_F(CompareScans, LittleOfTheWeldIsAPoorResult)
{
  IdealWeld weld;
  weld.height = 0.0003;
  const auto narrow = [&weld](double x, double y) { return std::abs(x) < 0.0045 ? NAN : weld(x, y); };
  save(longerScanner(6)(narrow), "narrow.pcd");
  const CommandResult result = compare("--no-report --out ground before.pcd narrow.pcd");
  EXPECT_EQ(result.status, 3) << result.errors;
  EXPECT_LT(record("ground")["measured_share"].as<double>(), 0.5);
  EXPECT_TRUE(record("ground")["removed_volume"]["value"].IsScalar());
  EXPECT_TRUE(result.says("missing in the scan after")) << result.errors;
}

TEST_F(CompareScans, FollowsScanBag)
{
  // the scan after begins and ends two rows further out
  write("before.yaml", "preset: realistic\nseed: 3\nframe_count: 16\nweld: {kind: bead_on_plate, start: -0.02}\n");
  write("after.yaml",
        "preset: realistic\nseed: 4\nframe_count: 20\nstart_position: -0.0005\n"
        "weld: {kind: bead_on_plate, start: -0.02, reinforcement: 0.0}\n");
  simulateAndScan("before");
  simulateAndScan("after");
  const CommandResult result = compare("--no-report --out ground before after");
  ASSERT_EQ(result.status, 0) << result.errors;
  const YAML::Node json = record("ground");
  EXPECT_EQ(json["id"].as<std::string>(), "seam");
  EXPECT_FALSE(json["calibration"]["hash"].as<std::string>().empty());
  const double truth = segmentArea(0.010, 0.002) * 15 * 2.5e-4;  // rows 0.25 mm apart, the first to the last
  EXPECT_NEAR(json["removed_volume"]["value"].as<double>(), truth, 0.01 * truth);
  EXPECT_NEAR(json["remaining_volume"]["value"].as<double>(), 0.0, 0.01 * truth);
  EXPECT_EQ(json["over_ground"].size(), 0u);
}

TEST_F(CompareScans, RefusesWhatCannotBeCompared)
{
  refuses("after.pcd", { "BEFORE and AFTER", "1 were given" }, 2);
  refuses("before.pcd after.pcd after.pcd", { "3 were given" }, 2);
  refuses("nowhere.pcd after.pcd", { "nowhere.pcd", "no such file" });
  std::filesystem::create_directory(path("empty"));
  refuses("empty after.pcd", { "empty", "scan.pcd" });
  write("text.pcd", "no cloud\n");
  refuses("before.pcd text.pcd", { "text.pcd" });
  IdealWeld none;
  none.width = 0.0;
  save(longerScanner(7)(none), "flat.pcd");
  refuses("flat.pcd after.pcd", { "flat.pcd and after.pcd cannot be compared", "shows no weld" });
  none.misalignment = 0.001;
  save(longerScanner(7)(none), "other.pcd");
  refuses("before.pcd other.pcd", { "parents do not match" });
  IdealScanner elsewhere;
  elsewhere.first_y = 0.05;
  save(elsewhere(IdealWeld()), "elsewhere.pcd");
  refuses("before.pcd elsewhere.pcd", { "do not overlap" });
}

TEST_F(CompareScans, RefusesDamagedRecordsAndNumbers)
{
  refuses("--threshold nan before.pcd after.pcd", { "over_ground_limit" });
  refuses("--placement 0 before.pcd after.pcd", { "placement" });
  refuses("--params nowhere.yaml before.pcd after.pcd", { "nowhere.yaml" });
  std::filesystem::create_directory(path("scan"));
  std::filesystem::copy_file(path("before.pcd"), path("scan/scan.pcd"));
  write("scan/weld.json", "{\"id\": ");
  refuses("scan after.pcd", { "weld.json", "damaged" });
  write("scan/weld.json", R"({"settings": {"rest_height": "high"}})");
  refuses("scan after.pcd", { "weld.json", "rest_height" });
  write("scan/weld.json", R"({"settings": {"rest_height": 5.0}})");
  refuses("scan after.pcd", { "weld.json", "rest_height" });
  write("scan/weld.json", "[1, 2]");
  refuses("scan after.pcd", { "weld.json", "no record" });
}

TEST_F(CompareScans, RefusesAFolderThatCannotBeWritten)
{
  write("file", "in the way");
  EXPECT_EQ(compare("--no-report --out file before.pcd after.pcd").status, 1);
  std::filesystem::create_directories(path("ground/compare.json"));
  const CommandResult result = compare("--no-report --out ground before.pcd after.pcd");
  EXPECT_EQ(result.status, 1);
  EXPECT_TRUE(result.says("compare.json")) << result.errors;
  EXPECT_EQ(filesIn("ground"), (std::vector<std::string>{ "compare.json" }));
  const CommandResult full = run("compare_scans", "--no-report --out limited before.pcd after.pcd", "ulimit -f 100");
  EXPECT_EQ(full.status, 1) << "a disk that is full after 100 kB";
  EXPECT_EQ(full.errorLines(), 1) << full.errors;
  EXPECT_TRUE(filesIn("limited").empty());
}

/// As soon as the report is all that is missing: compare_scans alone, or with its report program as a terminal does.
TEST_F(CompareScans, InterruptedLeavesTheFolderAsItWas)
{
  ASSERT_EQ(compare("--no-report --threshold 0.2 --out ground before.pcd after.pcd").status, 0);
  const std::string before = text("ground/compare.json");
  for (const std::string& who : { std::string("$pid"), std::string("-$pid") })
  {
    write("interrupt.sh",
          "set -m\n" WELD_PROFILER_COMMANDS
          "/compare_scans --out ground before.pcd after.pcd 2> errors &\n"
          "pid=$!\n"
          "until [ -e ground/.comparison.partial.$pid/difference.pcd ] || ! kill -0 $pid; do sleep 0.02; done\n"
          "sleep 0.2\nkill -INT -- " +
              who + "\nwait $pid\n");
    const int status = std::system(("cd " + path("") + " && bash interrupt.sh > /dev/null 2>&1").c_str());
    EXPECT_EQ(WEXITSTATUS(status), 130) << who << ": " << text("errors");
    EXPECT_EQ(text("errors"), "compare_scans: interrupted, nothing was written\n") << who;
    EXPECT_EQ(filesIn("ground"), (std::vector<std::string>{ "compare.json", "difference.pcd" })) << who;
    EXPECT_EQ(text("ground/compare.json"), before) << who;
  }
}

TEST_F(CompareScans, TeachesItself)
{
  const CommandResult result = compare("--help");
  EXPECT_EQ(result.status, 0);
  EXPECT_NE(result.output.find("examples:\n  compare_scans --out ground before after"), std::string::npos);
  EXPECT_EQ(compare("before.pcd after.pcd").status, 2) << "no --out";
}
}  // namespace
}  // namespace weld_profiler
