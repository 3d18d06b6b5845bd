#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <set>

#include "support/csv_fields.h"
#include "tools/dataset_plan.h"
#include "tools/run_command_line.h"

namespace weld_profiler
{
namespace
{
std::vector<std::map<std::string, std::string>> readIndex(const std::string& text)
{
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  const std::vector<std::string> columns = csvFields(line);
  std::vector<std::map<std::string, std::string>> rows;
  while (std::getline(lines, line))
  {
    const std::vector<std::string> words = csvFields(line);
    EXPECT_EQ(words.size(), columns.size()) << line;
    std::map<std::string, std::string> row;
    for (std::size_t i = 0; i < std::min(words.size(), columns.size()); ++i)
      row[columns[i]] = words[i];
    rows.push_back(row);
  }
  return rows;
}

/// Points by label, holes as label 9.
std::map<std::uint32_t, std::size_t> labelsIn(const std::string& pcd)
{
  constexpr std::size_t kStep = 40;
  const std::string marker = "DATA binary\n";
  const std::size_t begin = pcd.find(marker) + marker.size();
  std::map<std::uint32_t, std::size_t> counts;
  for (std::size_t at = begin; at + kStep <= pcd.size(); at += kStep)
  {
    float x = 0.0F;
    std::uint32_t label = 0;
    std::memcpy(&x, pcd.data() + at, sizeof x);
    std::memcpy(&label, pcd.data() + at + 32, sizeof label);
    ++counts[x == x ? label : 9];
  }
  return counts;
}

/// A cloud whose points are those that its line of the index tells of.
void expectAsListed(std::map<std::string, std::string> row, const std::string& pcd)
{
  EXPECT_NE(pcd.find("FIELDS x y z intensity sigma stage time flags"), std::string::npos) << row["file"];
  EXPECT_NE(pcd.find("label removal"), std::string::npos);
  EXPECT_NE(pcd.find("WIDTH 1440"), std::string::npos) << "organised";
  EXPECT_NE(pcd.find("HEIGHT " + row["rows"]), std::string::npos);
  auto labels = labelsIn(pcd);
  EXPECT_EQ(std::to_string(labels[1]), row["base"]);
  EXPECT_EQ(std::to_string(labels[2]), row["bead"]);
  EXPECT_EQ(std::to_string(labels[3]), row["undercut"]);
  EXPECT_EQ(std::to_string(labels[4]), row["spatter"]);
  // the bead takes its width's share of the field of about 60 mm, or a little more where the weld is oblique
  const double points = std::stod(row["points"]);
  EXPECT_NEAR(labels[2] / points, std::stod(row["width_mm"]) / 60.0, 0.06) << row["file"];
  EXPECT_GT(labels[1] / points, 0.5);
  EXPECT_GT(points, 0.9 * std::stod(row["rows"]) * 1440.0);
}

class WeldDataset : public CommandTest
{
protected:
  CommandResult make(const std::string& out, int count, const std::string& more = "") const
  {
    return run("weld_dataset", "--out " + out + " --count " + std::to_string(count) + " --seed 5 " + more);
  }
};

TEST_F(WeldDataset, HasACloudOfEachKindAndALineForEach)
{
  const CommandResult result = make("set", 3);
  ASSERT_EQ(result.status, 0) << result.errors;
  EXPECT_EQ(result.errors, "") << "quiet in a pipe";
  const auto rows = readIndex(text("set/index.csv"));
  ASSERT_EQ(rows.size(), 3u);
  std::set<std::string> kinds;
  for (auto row : rows)
  {
    kinds.insert(row["kind"]);
    expectAsListed(row, text("set/" + row["file"]));
  }
  EXPECT_EQ(kinds, (std::set<std::string>{ "butt", "fillet", "bead_on_plate" }));

  // cut short and gone on with: the same bytes
  std::filesystem::copy(path("set"), path("again"), std::filesystem::copy_options::recursive);
  std::filesystem::remove(path("again/" + rows[1].at("file")));
  write("again/train/.weld_000001.pcd.77.0.tmp", "half a cloud");
  ASSERT_EQ(make("again", 3).status, 0);
  for (const auto& row : rows)
    EXPECT_EQ(text("set/" + row.at("file")), text("again/" + row.at("file"))) << row.at("file");
  EXPECT_EQ(text("set/index.csv"), text("again/index.csv"));
  EXPECT_EQ(filesIn("again"), (std::vector<std::string>{ "dataset.yaml", "index.csv", "train", "validation" }));
  EXPECT_EQ(filesIn("again/train").size() + filesIn("again/validation").size(), 3u) << "what was left over is gone";

  // another seed is another data set, and something foreign is not swept away
  EXPECT_EQ(run("weld_dataset", "--out again --count 3 --seed 6").status, 1);
  write("again/notes.txt", "mine");
  const CommandResult foreign = make("again", 3);
  EXPECT_EQ(foreign.status, 1);
  EXPECT_EQ(foreign.errorLines(), 1);
  EXPECT_TRUE(foreign.says("notes.txt")) << foreign.errors;
}

TEST_F(WeldDataset, RefusesAFolderThatIsNoDataSet)
{
  std::filesystem::create_directory(path("mine"));
  write("mine/letter.txt", "dear");
  const CommandResult result = make("mine", 1);
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.errorLines(), 1);
  EXPECT_TRUE(result.says("mine")) << result.errors;
  EXPECT_EQ(filesIn("mine"), (std::vector<std::string>{ "letter.txt" }));
}

TEST_F(WeldDataset, RefusesNumbersOutOfRange)
{
  EXPECT_EQ(make("set", 0).status, 2);
  EXPECT_EQ(make("set", 1, "--validation 0.95").status, 2);
  EXPECT_EQ(make("set", 1, "--validation nan").status, 2);
  EXPECT_EQ(run("weld_dataset", "--out set --count 1 --seed -1").status, 2);
  EXPECT_EQ(run("weld_dataset", "--count 1 --seed 1").status, 2);
  EXPECT_EQ(filesIn("."), (std::vector<std::string>{}));
}

TEST(DatasetPlan, HoldsOutTheAskedShareOfEachKind)
{
  for (const std::uint64_t seed : { 1, 2, 3 })
  {
    const DatasetPlan plan{ seed, 0.2 };
    std::array<int, 3> held_out{};
    std::set<std::uint64_t> scenes, kinds;
    for (int index = 0; index < 300; ++index)
    {
      const DatasetEntry entry = plan.entry(index);
      kinds.insert(entry.scene_seed % 3);
      if (index % 3 == 2)
      {
        EXPECT_EQ(kinds.size(), 3u) << "kinds take turns";
        kinds.clear();
      }
      EXPECT_EQ(entry.file.compare(0, entry.split.size(), entry.split), 0);
      held_out[entry.scene_seed % 3] += entry.split == "validation" ? 1 : 0;
      scenes.insert(entry.scene_seed);
    }
    EXPECT_EQ(scenes.size(), 300u) << "no weld twice";
    for (const int count : held_out)
      EXPECT_NEAR(count, 20, 1);
  }
}

TEST(DatasetPlan, HoldsOutTheAskedShareOfTheFirstFewAndOfTheirKinds)
{
  int checked = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed)
    for (const double share : { 0.1, 1.0 / 9.0, 0.2, 0.25, 1.0 / 3.0, 0.5, 2.0 / 3.0, 0.9 })
    {
      const DatasetPlan plan{ seed, share };
      int all = 0;
      std::array<int, 3> of_kind{};
      for (int index = 0; index < 60; ++index)
      {
        const DatasetEntry entry = plan.entry(index);
        const int held_out = entry.split == "validation" ? 1 : 0;
        all += held_out;
        of_kind[entry.scene_seed % 3] += held_out;
        EXPECT_LT(std::abs(all - share * (index + 1)), 1.0) << "seed " << seed << ", share " << share;
        const auto [least, most] = std::minmax_element(of_kind.begin(), of_kind.end());
        EXPECT_LE(*most - *least, index % 3 == 2 ? 1 : 2);
        checked += index == 7 && share == 0.25 && all == 2 ? 1 : 0;
      }
    }
  EXPECT_EQ(checked, 40) << "2 of 8";
}

TEST(DatasetPlan, AnotherSeedHasOtherWelds)
{
  EXPECT_NE((DatasetPlan{ 1, 0.2 }.entry(0).scene_seed), (DatasetPlan{ 2, 0.2 }.entry(0).scene_seed));
  EXPECT_EQ((DatasetPlan{ 1, 0.0 }.entry(12).split), "train");
}
}  // namespace
}  // namespace weld_profiler
