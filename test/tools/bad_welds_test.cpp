// Scans that are not as a weld's should be, from the images to the files: measured where possible, said where not.
#include <cmath>
#include <map>
#include <random>

#include <sensor_msgs/Image.h>
#include <yaml-cpp/yaml.h>

#include "bag_rewrite.h"
#include "csv_table.h"
#include "run_command_line.h"

namespace weld_profiler
{
namespace
{
// the default rig, a smaller region; rows 0.2 mm apart
const char* const kRig = R"(preset: realistic
frame_rate: 25
camera:
  image_width: 1440
  image_height: 1080
  camera_matrix: [6000.0, 0.0, 719.5, 0.0, 6000.0, 539.5, 0.0, 0.0, 1.0]
  distortion_model: plumb_bob
  distortion_coefficients: [0.0, 0.0, 0.0, 0.0, 0.0]
  roi: {x_offset: 0, y_offset: 420, width: 1440, height: 240}
)";

const char* const kMiddle = "frame_count: 50\npart_start: 0.012\n";  // 10 mm of a long weld
const char* const kWhole = "frame_count: 150\n";                     // 30 mm, its first end among them

class BadWelds : public CommandTest
{
protected:
  void simulate(const std::string& part, const std::string& stretch = kMiddle) const
  {
    write("scene.yaml", kRig + stretch + part);
    const CommandResult result = run("simulate_scan", "--scene scene.yaml --out weld.bag");
    ASSERT_EQ(result.status, 0) << result.errors;
  }

  /// Scans and measures a bag, and reads what it left. @return what was said on standard error.
  std::string measure(const std::string& bag = "weld.bag", const std::string& options = "")
  {
    const CommandResult result =
        run("scan_bag", "--calibration weld.bag.truth/calibration.yaml --no-report " + options + " --out scan " + bag);
    EXPECT_EQ(result.status, 0) << result.errors;
    EXPECT_EQ(result.errorLines(), 2) << result.errors;
    weld_ = YAML::Load(text("scan/weld.json"));
    sections_ = csvTable(text("scan/weld.csv"));
    for (const char* name : { "weld.json", "weld.csv", "verdict.csv", "spots.csv", "passes.csv" })
    {
      const std::string content = text(std::string("scan/") + name);
      EXPECT_FALSE(content.empty()) << name;
      for (const char* word : { ",nan", ",-nan", ",inf", ",-inf", ": nan", ": inf" })
        EXPECT_EQ(content.find(word), std::string::npos) << name << " holds" << word;
    }
    EXPECT_NE(text("scan/weld_points.pcd").find("DATA binary\n"), std::string::npos);
    return result.errors;
  }

  std::string kind() const { return weld_["kind"].as<std::string>(); }
  std::string reason() const { return weld_["reason"].as<std::string>(); }

  /// No weld, and a reason of one line for it; no size of a bead anywhere.
  void expectNoWeld(const std::string& words)
  {
    const std::string said = measure();
    EXPECT_EQ(kind(), "none");
    EXPECT_NE(reason().find(words), std::string::npos) << reason();
    EXPECT_NE(said.find("no weld: " + reason()), std::string::npos) << said;
    EXPECT_TRUE(sections_.measured("width_mm").empty());
    EXPECT_TRUE(sections_.measured("reinforcement_mm").empty());
    EXPECT_TRUE(weld_["volume"]["value"].IsNull());
    EXPECT_EQ(weld_["verdict"]["overall"].as<std::string>(), "");
    EXPECT_FALSE(std::filesystem::exists(path("scan/bead.ply")));
    EXPECT_EQ(csvTable(text("scan/passes.csv")).rows.size(), 0u);
  }

  /// @return how many sections have a width. Each is near to what it is; a sigma may excuse it.
  std::size_t expectWidths(double width, double tolerance) const
  {
    for (const auto& row : sections_.rows)
    {
      if (std::isfinite(row.at("width_mm")))
      {
        EXPECT_NEAR(row.at("width_mm"), width, std::max(tolerance, 4.0 * row.at("sigma_width_mm")))
            << "row " << row.at("row");
      }
    }
    return sections_.measured("width_mm").size();
  }

  /// weld.bag with every image through change.
  void withImages(const std::string& target, const std::function<void(sensor_msgs::Image&)>& change) const
  {
    rewriteBag<sensor_msgs::Image>(path("weld.bag"), path(target),
                                   [&](std::size_t, sensor_msgs::Image& image)
                                   {
                                     change(image);
                                     return true;
                                   });
  }

  YAML::Node weld_;
  CsvTable sections_;
};
}  // namespace

TEST_F(BadWelds, AnEmptyPlateHasNoWeld)
{
  simulate("weld: {width: 0.0}\n");
  expectNoWeld("no bead");
}

TEST_F(BadWelds, OfTwoBeadsTheStrongerIsMeasuredTheOtherNamed)
{
  simulate(
      "weld: {width: 0.008, reinforcement: 0.0016}\nplates: {x: -0.006}\n"
      "second_bead: {offset: 0.016, width: 0.005, reinforcement: 0.0008}\n");
  const std::string said = measure();
  EXPECT_EQ(kind(), "bead_on_plate");
  EXPECT_GE(expectWidths(8.0, 0.1), 40u);
  ASSERT_EQ(weld_["other_beads"].size(), 1u);
  EXPECT_NEAR(weld_["other_beads"][0]["x"].as<double>(), 0.010, 5e-4);
  EXPECT_NE(said.find("another bead at x "), std::string::npos) << said;
}

TEST_F(BadWelds, AtTheEdgeOfTheFieldOrWithoutOneParentNoWidthIsMadeUp)
{
  for (const char* x : { "0.028", "0.0255" })
  {
    simulate(std::string("weld: {width: 0.008, reinforcement: 0.0015}\nplates: {x: ") + x + "}\n");
    expectNoWeld("a parent is not in view");
  }
}

TEST_F(BadWelds, CratersAndEndsAreNoWiderThanTheyAre)
{
  simulate(
      "weld: {kind: bead_on_plate, width: 0.009, reinforcement: 0.0018, start: 0.004, length: 0.022,"
      " crater_start: 0.0005, crater_end: 0.0012}\n",
      kWhole);
  measure();
  const CsvTable truth = csvTable(text("weld.bag.truth/weld.csv"));
  std::map<int, double> widths;
  for (const auto& row : truth.rows)
    widths[static_cast<int>(row.at("row"))] = row.at("width_mm");
  EXPECT_GE(sections_.measured("width_mm").size(), 80u);
  for (const auto& row : sections_.rows)
  {
    if (!std::isfinite(row.at("width_mm")))
      continue;
    const auto found = widths.find(static_cast<int>(row.at("row")));
    ASSERT_NE(found, widths.end()) << "a width in row " << row.at("row") << ", where there is no bead";
    EXPECT_NEAR(row.at("width_mm"), found->second, std::max(0.25, 4.0 * row.at("sigma_width_mm")));
  }
}

TEST_F(BadWelds, ThreeRowsAreMeasuredAndTheVerdictSaysOnHowMuch)
{
  simulate("weld: {width: 0.008, reinforcement: 0.0015}\n");
  std::size_t frames = 0;
  rewriteBag<sensor_msgs::Image>(path("weld.bag"), path("three.bag"),
                                 [&](std::size_t, sensor_msgs::Image&) { return frames++ < 3; });
  measure("three.bag");
  EXPECT_EQ(expectWidths(8.0, 0.1), 3u) << reason();
  EXPECT_NE(text("scan/weld.json").find("mm of weld were seen"), std::string::npos);
}

TEST_F(BadWelds, ThroughSixtyPercentHolesNothingIsMadeUp)
{
  simulate("weld: {width: 0.008, reinforcement: 0.0015}\n");
  std::mt19937 random(3);
  withImages("holes.bag",
             [&](sensor_msgs::Image& image)
             {
               for (std::size_t column = 0; column < image.width; ++column)
               {
                 const bool hole = random() % 10 < 6;
                 for (std::size_t row = 0; hole && row < image.height; ++row)
                   image.data[row * image.step + column] = 5;
               }
             });
  measure("holes.bag");
  EXPECT_EQ(kind(), "bead_on_plate") << reason();
  EXPECT_GE(expectWidths(8.0, 0.15), 10u);
}

TEST_F(BadWelds, AScanUpsideDownSaysSo)
{
  simulate("weld: {width: 0.008, reinforcement: 0.0015}\n");
  withImages("flipped.bag",
             [](sensor_msgs::Image& image)
             {
               for (std::size_t row = 0; row < image.height / 2; ++row)
                 std::swap_ranges(image.data.begin() + static_cast<std::ptrdiff_t>(row * image.step),
                                  image.data.begin() + static_cast<std::ptrdiff_t>((row + 1) * image.step),
                                  image.data.end() - static_cast<std::ptrdiff_t>((row + 1) * image.step));
             });
  std::filesystem::rename(path("flipped.bag"), path("weld.bag"));
  expectNoWeld("upside down");
}

TEST_F(BadWelds, TackWeldsBesideAClampAreMeasuredWhereTheyAre)
{
  simulate(
      "plates: {misalignment: 0.0003}\n"
      "weld: {width: 0.007, reinforcement: 0.0016, start: 0.002, length: 0.026, end_length: 0.002,"
      " tack_length: 0.01, tack_gap: 0.006}\n"
      "gauge: {height: 0.003, x: -0.016, y: 0.008, width: 0.008, length: 0.012}\n",
      kWhole);
  measure();
  EXPECT_EQ(kind(), "butt") << reason();
  std::size_t first = 0, second = 0;
  for (const auto& row : sections_.rows)
  {
    if (!std::isfinite(row.at("width_mm")))
      continue;
    const double y = row.at("stage_mm");
    EXPECT_FALSE(y > 12.4 && y < 17.6) << "a width between the tacks, at " << y;
    EXPECT_LE(row.at("width_mm"), 7.3);
    first += y < 12.4 ? 1 : 0, second += y > 17.6 ? 1 : 0;
  }
  EXPECT_GE(first, 10u);
  EXPECT_GE(second, 10u);
}

TEST_F(BadWelds, AnAbsurdThicknessIsRefusedOrSaid)
{
  simulate("weld: {width: 0.008, reinforcement: 0.0015}\n");
  for (const char* value : { "8", "-1", ".nan", ".inf", "thick" })
  {
    write("params.yaml", std::string("weld_measurement: {thickness: ") + value + "}\n");
    const CommandResult result =
        run("scan_bag", "--calibration weld.bag.truth/calibration.yaml --params params.yaml --out refused weld.bag");
    EXPECT_EQ(result.status, 1) << value;
    EXPECT_EQ(result.errorLines(), 1) << result.errors;
    EXPECT_TRUE(result.says("thickness")) << result.errors;
    EXPECT_FALSE(std::filesystem::exists(path("refused")));
  }
  write("params.yaml", "weld_measurement: {thickness: 0.0003}\n");
  const std::string said = measure("weld.bag", "--params params.yaml");
  EXPECT_EQ(weld_["verdict"]["overall"].as<std::string>(), "") << "thinner than the standard's scope";
  EXPECT_NE(said.find("thickness 0.3 mm is below the scope"), std::string::npos) << said;
  write("params.yaml", "weld_measurement: {thickness: 0.8}\n");
  measure("weld.bag", "--params params.yaml");
  EXPECT_NE(text("scan/weld.json").find("is it given in metres?"), std::string::npos);
}
}  // namespace weld_profiler
