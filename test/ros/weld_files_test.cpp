// The folder a measured weld leaves: complete, and each file says of which weld, calibration and settings it is.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include "support/temporary_folder.h"
#include "weld/ideal_scan.h"
#include "weld_profiler/core/checksum.h"
#include "weld_profiler/core/errors.h"
#include "weld_profiler/ros/origin.h"
#include "weld_profiler/ros/weld_files.h"

namespace weld_profiler
{
namespace
{
std::string readText(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

class WeldFiles : public ::testing::Test
{
protected:
  std::vector<std::string> write(const Scan& scan, const std::string& id = "K-17")
  {
    const WeldEvaluation evaluation = WeldEvaluator(settings_).evaluate(scan);
    return writeWeldFiles(scan, evaluation, settings_, { id, { "rig.yaml", "0123456789abcdef", "" } },
                          folder_.path().string());
  }
  YAML::Node record() const { return YAML::Load(readText(folder_.file("weld.json"))); }

  TemporaryFolder folder_;
  WeldSettings settings_;
};
}  // namespace

TEST_F(WeldFiles, EachSaysOfWhichWeldCalibrationAndSettingsItIs)
{
  const std::vector<std::string> files = write(IdealScanner()(IdealWeld()));
  ASSERT_EQ(files.size(), 8u) << "weld.json, four tables, a cloud, two meshes";
  const std::string settings = checksum(settingsText(settings_));
  for (const std::string& file : files)
  {
    const std::string head = readText(file).substr(0, 16384);
    if (std::count(head.begin(), head.end(), '\n') == 1)
      continue;  // a table without a line: no spots
    for (const std::string& word : { std::string("K-17"), std::string("0123456789abcdef"), settings })
      EXPECT_NE(head.find(word), std::string::npos) << file << " does not say " << word;
    if (file.find(".csv") != std::string::npos)
      continue;
    for (const char* word : { "weld_profiler 0.", "min_width", "depth_per_pass", "smallest_imperfection" })
      EXPECT_NE(head.find(word), std::string::npos) << file << " does not say " << word;
  }
}

TEST_F(WeldFiles, AnotherSettingIsAnotherHash)
{
  const std::string before = checksum(settingsText(settings_));
  settings_.grinding.overlap = 0.31;
  EXPECT_NE(checksum(settingsText(settings_)), before);
}

TEST_F(WeldFiles, TablesStayTables)
{
  write(IdealScanner()(IdealWeld()), "a, \"b\"");
  for (const char* name : { "weld.csv", "verdict.csv", "passes.csv" })
  {
    std::istringstream lines(readText(folder_.file(name)));
    std::string line;
    std::getline(lines, line);
    const auto commas = std::count(line.begin(), line.end(), ',');
    EXPECT_EQ(line.find("weld_id"), line.size() - std::string("weld_id,calibration_hash,settings_hash").size());
    int count = 0;
    for (; std::getline(lines, line); ++count)
    {
      EXPECT_EQ(std::count(line.begin(), line.end(), ','), commas) << name << ": " << line;
      EXPECT_NE(line.find(",a; 'b',0123456789abcdef,"), std::string::npos) << line;
    }
    EXPECT_GT(count, 0) << name;
  }
}

TEST_F(WeldFiles, WeldJsonStatesTheLimitsOfTheHeight)
{
  write(IdealScanner()(IdealWeld()));
  EXPECT_EQ(record()["software"].as<std::string>(), software());
  EXPECT_EQ(record()["settings_hash"].as<std::string>(), checksum(settingsText(settings_)));
  const YAML::Node limits = record()["verdict"]["height_limits"];
  ASSERT_EQ(limits.size(), 3u);
  const LimitEntry* entry = WeldJudge(settings_.judging).entry(Imperfection::ExcessWeldMetal, WeldKind::BeadOnPlate);
  ASSERT_NE(entry, nullptr);
  for (const QualityLevel level : kQualityLevels)
  {
    EXPECT_DOUBLE_EQ(limits[name(level)]["base"].as<double>(), entry->at(level).base);
    EXPECT_DOUBLE_EQ(limits[name(level)]["factor"].as<double>(), entry->at(level).factor);
    EXPECT_DOUBLE_EQ(limits[name(level)]["cap"].as<double>(), entry->at(level).cap);
  }
}

TEST_F(WeldFiles, WeldJsonNamesTheLimitsThatNeedAThickness)
{
  settings_.judging.level = "D";
  write(IdealScanner()(IdealWeld()));
  const YAML::Node part = record()["verdict"];
  ASSERT_EQ(part["lacks_thickness"].size(), 1u) << part;
  EXPECT_EQ(part["lacks_thickness"][0].as<std::string>(), "undercut") << "of a bead on a plate";
  EXPECT_EQ(part["asked_decision"].as<std::string>(), "not_judged");
  settings_.judging.thickness = 0.008;
  write(IdealScanner()(IdealWeld()));
  EXPECT_EQ(record()["verdict"]["lacks_thickness"].size(), 0u);
  EXPECT_EQ(record()["verdict"]["asked_decision"].as<std::string>(), "pass");
}

TEST_F(WeldFiles, WeldJsonCountsTheSectionsThatWaitForWhatSpatterHides)
{
  const IdealWeld weld;
  const auto surface = [&weld](double x, double y)
  {
    const double rest = 2.5e-7 - (x - 0.0052) * (x - 0.0052) - (y - 0.006) * (y - 0.006);
    return weld(x, y) + (rest > 0.0 ? std::sqrt(rest) : 0.0);
  };
  settings_.judging.thickness = 0.004;
  write(IdealScanner()(surface));
  const YAML::Node verdict = record()["verdict"];
  ASSERT_EQ(verdict["sections_waiting"].size(), 1u) << verdict;
  const int waiting = verdict["sections_waiting"]["undercut right"].as<int>();
  EXPECT_GE(waiting, 3) << "rows 0.2 mm apart, a ball of 1 mm";
  EXPECT_LE(waiting, 9);
  EXPECT_EQ(verdict["waits_for"].size(), 0u) << "elsewhere it was measured";
  const std::string csv = readText(folder_.file("weld.csv"));
  int undecided = 0;
  for (std::size_t at = csv.find(",undecided,"); at != std::string::npos; at = csv.find(",undecided,", at + 1))
    ++undecided;
  EXPECT_EQ(undecided, waiting);
}

TEST_F(WeldFiles, WeldJsonSaysWhyThereIsNothingToGrind)
{
  const Scan scan = IdealScanner()(IdealWeld());
  write(scan);
  EXPECT_GT(record()["grinding_passes"].as<int>(), 0);
  EXPECT_EQ(record()["grinding_reason"].as<std::string>(), "");
  settings_.grinding.surface.edge_inset = 5e-3;
  write(scan);
  EXPECT_EQ(record()["grinding_passes"].as<int>(), 0);
  EXPECT_NE(record()["grinding_reason"].as<std::string>().find("edge_inset 5 mm leaves nothing of the bead"),
            std::string::npos);
  settings_.grinding.surface.edge_inset = 0.0;
  settings_.measuring.target = "rest";
  settings_.measuring.rest_height = 5e-3;
  write(scan);
  EXPECT_EQ(record()["grinding_passes"].as<int>(), 0);
  EXPECT_NE(record()["grinding_reason"].as<std::string>().find("nothing stands more than min_removal"),
            std::string::npos)
      << record()["grinding_reason"];
}

TEST_F(WeldFiles, WithoutAWeldLeavesNoMeshOfAnEarlierOneAndNoReport)
{
  write(IdealScanner()(IdealWeld()));
  std::ofstream(folder_.file("report.html")) << "of the earlier one";
  std::ofstream(folder_.file("report.png")) << "of the earlier one";
  std::ofstream(folder_.file("notes.txt")) << "somebody's";
  ASSERT_TRUE(std::filesystem::exists(folder_.file("bead.ply")));
  const auto plate = [](double, double) { return 0.0; };
  EXPECT_EQ(write(IdealScanner()(plate)).size(), 6u);
  EXPECT_FALSE(std::filesystem::exists(folder_.file("bead.ply")));
  EXPECT_FALSE(std::filesystem::exists(folder_.file("target.ply")));
  EXPECT_FALSE(std::filesystem::exists(folder_.file("report.html")));
  EXPECT_FALSE(std::filesystem::exists(folder_.file("report.png")));
  EXPECT_TRUE(std::filesystem::exists(folder_.file("notes.txt")));
  EXPECT_EQ(record()["kind"].as<std::string>(), "none");
  EXPECT_EQ(record()["verdict"]["height_limits"].size(), 0u);
}

TEST_F(WeldFiles, AnIdIsOneLineOfUtf8)
{
  const Scan scan = IdealScanner()(IdealWeld());
  EXPECT_THROW(write(scan, "two\nlines"), ConfigError);
  EXPECT_THROW(write(scan, std::string(101, 'x')), ConfigError);
  for (const char* id : { "N\xe4ht", "N\xc3", "\xc0\xafy", "\xed\xa0\x80", "\xf5\x80\x80\x80", "\xe2\x82" })
    EXPECT_THROW(write(scan, id), ConfigError) << "no UTF-8";
  EXPECT_NO_THROW(requireWeldId("N\xc3\xa4ht \xe2\x82\xac \xf0\x9f\x94\xa5"));
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path())) << "nothing was written";
}

TEST_F(WeldFiles, WhatAnEarlierRunLeftGoesAndWhatIsFreshOrSomebodysStays)
{
  namespace fs = std::filesystem;
  const auto fill = [this](bool summary)
  {
    fs::remove_all(folder_.path());
    for (const char* folder : { "scan", "scan_2", "scan_3" })
      fs::create_directories(folder_.file(folder));
    for (const char* name : { "scan.pcd", "scan.ply", "scan_2.pcd", "scan_3.ply", "weld.json", "report.png",
                              "notes.txt", "scan.txt", "scan/weld.json", "scan_2/weld.csv", "scan_3/notes.txt" })
      std::ofstream(folder_.file(name)) << "x";
    if (summary)
      std::ofstream(folder_.file("summary.json")) << "x";
  };
  const auto left = [this](const FreshFiles& fresh)
  {
    removeStaleFiles(folder_.path().string(), fresh);
    std::vector<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(folder_.path()))
      names.push_back(fs::relative(entry.path(), folder_.path()).string());
    std::sort(names.begin(), names.end());
    return names;
  };
  fill(true);
  EXPECT_EQ(left(FreshFiles{ 0, false }), (std::vector<std::string>{ "notes.txt", "scan", "scan.txt", "scan/weld.json",
                                                                     "scan_3", "scan_3/notes.txt" }));
  fill(true);
  EXPECT_EQ(left(FreshFiles{ 2, true }),
            (std::vector<std::string>{ "notes.txt", "scan", "scan.pcd", "scan.ply", "scan.txt", "scan/weld.json",
                                       "scan_2", "scan_2.pcd", "scan_3", "scan_3/notes.txt", "summary.json" }));
  fill(true);
  fs::remove_all(folder_.file("scan_2"));
  fs::create_directory_symlink(folder_.file("scan_3"), folder_.file("scan_2"));
  fs::create_directory_symlink("loop", folder_.file("loop"));
  std::ofstream(folder_.file("scan_3/weld.csv")) << "x";
  removeStaleFiles(folder_.path().string(), FreshFiles{ 3, true });
  EXPECT_TRUE(fs::is_symlink(folder_.file("scan_2")) && fs::is_symlink(folder_.file("loop")));
  fill(false);
  EXPECT_EQ(
      left(FreshFiles{ 0, false }),
      (std::vector<std::string>{ "notes.txt", "scan", "scan.pcd", "scan.ply", "scan.txt", "scan/weld.json", "scan_2",
                                 "scan_2.pcd", "scan_2/weld.csv", "scan_3", "scan_3.ply", "scan_3/notes.txt" }))
      << "clouds saved by hand";
}
}  // namespace weld_profiler
