#include "weld_profiler/simulation/truth_writer.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "simulation/scenes.h"
#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
namespace
{
namespace fs = std::filesystem;

class TruthWriter : public ::testing::Test
{
protected:
  void SetUp() override
  {
    folder_ = fs::temp_directory_path() / ("truth_" + std::to_string(getpid()));
    fs::remove_all(folder_);
    fs::create_directory(folder_);
    SceneParams scene = scenePreset("realistic");
    scene.frame_count = 3;
    scene.part_start = 0.02;
    scan_ = std::make_unique<SimulatedScan>(scene);
  }
  void TearDown() override { fs::remove_all(folder_); }

  static std::vector<std::string> lines(const fs::path& path)
  {
    std::ifstream file(path);
    std::vector<std::string> result;
    for (std::string line; std::getline(file, line);)
      result.push_back(line);
    return result;
  }

  static std::vector<std::string> fields(const std::string& line)
  {
    std::vector<std::string> result;
    std::istringstream text(line);
    for (std::string field; std::getline(text, field, ',');)
      result.push_back(field);
    return result;
  }

  fs::path folder_;
  std::unique_ptr<SimulatedScan> scan_;
};

TEST_F(TruthWriter, WritesEveryTrueCentre)
{
  int told = 0;
  writeTruth(*scan_, (folder_ / "a.truth").string(), [&told](int done, int total) { told += done == total ? 1 : 0; });
  EXPECT_EQ(told, 1);
  const auto rows = lines(folder_ / "a.truth" / "centres.csv");
  ASSERT_EQ(rows.size(), 1U + 3U * 1440U);
  EXPECT_EQ(rows[0], "frame,stamp,stage_m,cell,u_px,v_px,normal_rad,x_m,y_m,z_m,visible");
  const auto truth = scan_->truth(1);
  const auto row = fields(rows[1 + 1440 + 700]);
  ASSERT_EQ(row.size(), 11U);
  EXPECT_EQ(row[0], "1");
  EXPECT_EQ(row[1], "1000.050000000");
  EXPECT_EQ(row[3], "700");
  EXPECT_NEAR(std::stod(row[2]), 0.00025, 1e-9);
  EXPECT_NEAR(std::stod(row[4]), truth[700].u, 1e-6);
  EXPECT_NEAR(std::stod(row[5]), truth[700].v, 1e-6);
  EXPECT_NEAR(std::stod(row[6]), truth[700].normal_angle, 1e-9);
  EXPECT_NEAR(std::stod(row[9]), truth[700].z, 1e-9);
  EXPECT_EQ(row[10], "1");
}

TEST_F(TruthWriter, WritesTheWeldsSections)
{
  writeTruth(*scan_, (folder_ / "a.truth").string());
  const auto rows = lines(folder_ / "a.truth" / "weld.csv");
  ASSERT_EQ(rows.size(), 4U);
  const auto names = fields(rows[0]);
  const auto values = fields(rows[1]);
  ASSERT_EQ(names.size(), values.size());
  ASSERT_EQ(names[2], "width_mm");
  EXPECT_NEAR(std::stod(values[2]), 10.0, 1e-6);
  ASSERT_EQ(names[3], "reinforcement_mm");
  EXPECT_NEAR(std::stod(values[3]), 2.0, 0.06);
  const auto column = [&names](const std::string& name)
  { return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin()); };
  ASSERT_LT(column("kind"), names.size());
  EXPECT_EQ(values[column("reference")], "chord");
  EXPECT_EQ(values[column("kind")], "butt");
  EXPECT_EQ(values[column("leg_left_mm")], "") << "a butt weld has none";
  EXPECT_EQ(values[column("verdict")], "");
  EXPECT_EQ(column("section"), column("verdict") + 1U);
}

TEST_F(TruthWriter, WritesAFilletsLegsAndThroat)
{
  SceneParams scene = scenePreset("realistic");
  scene.frame_count = 2;
  scene.part_start = 0.02;
  scene.weld.kind = "fillet";
  scene.plates.angle_deg = 90.0;
  scene.weld.reinforcement = 0.001;
  writeTruth(SimulatedScan(scene), (folder_ / "b.truth").string());
  const auto rows = lines(folder_ / "b.truth" / "weld.csv");
  ASSERT_EQ(rows.size(), 3U);
  const auto names = fields(rows[0]);
  const auto values = fields(rows[1]);
  ASSERT_EQ(names.size(), values.size());
  ASSERT_EQ(names[20], "leg_left_mm");
  EXPECT_NEAR(std::stod(values[20]), 5.0 * M_SQRT2, 1e-6);
  ASSERT_EQ(names[22], "throat_mm");
  EXPECT_NEAR(std::stod(values[22]), 5.0, 1e-6);
  EXPECT_EQ(values.back(), "fillet");
  ASSERT_EQ(names[26], "angle_deg");
  EXPECT_NEAR(std::stod(values[26]), 90.0, 1e-4);
  ASSERT_EQ(names[10], "misalignment_mm");
  EXPECT_EQ(values[10], "") << "plates in a corner have none";
}

TEST_F(TruthWriter, WritesSpatterAndPores)
{
  SceneParams scene = scan_->scene();
  scene.spatter.count = 4;
  scene.pores.count = 3;
  const SimulatedScan scan(scene);
  writeTruth(scan, (folder_ / "c.truth").string());
  const auto rows = lines(folder_ / "c.truth" / "spots.csv");
  ASSERT_EQ(rows.size(), 8U);
  EXPECT_EQ(rows[0], "kind,x_mm,y_mm,z_mm,s_mm,diameter_mm,height_mm");
  EXPECT_EQ(fields(rows[1])[0], "spatter");
  EXPECT_EQ(fields(rows[7])[0], "pore");
  EXPECT_NEAR(std::stod(fields(rows[7])[5]), scan.spots()[6].diameter * 1000.0, 1e-6);
}

TEST_F(TruthWriter, WritesASurfaceThatLooksUp)
{
  writeTruth(*scan_, (folder_ / "a.truth").string());
  std::ifstream file(folder_ / "a.truth" / "surface.ply", std::ios::binary);
  std::string line;
  int vertices = 0, faces = 0;
  while (std::getline(file, line) && line != "end_header")
  {
    std::sscanf(line.c_str(), "element vertex %d", &vertices);
    std::sscanf(line.c_str(), "element face %d", &faces);
  }
  ASSERT_GT(vertices, 400);
  ASSERT_GT(faces, 200);
  std::vector<float> points(static_cast<std::size_t>(vertices) * 3U);
  file.read(reinterpret_cast<char*>(points.data()), static_cast<std::streamsize>(points.size() * sizeof(float)));
  for (int face = 0; face < faces; ++face)
  {
    unsigned char count = 0;
    std::array<std::int32_t, 3> corner{};
    file.read(reinterpret_cast<char*>(&count), 1);
    file.read(reinterpret_cast<char*>(corner.data()), sizeof(corner));
    ASSERT_EQ(count, 3);
    const auto x = [&](int i) { return points[static_cast<std::size_t>(3 * corner[static_cast<std::size_t>(i)])]; };
    const auto y = [&](int i) { return points[static_cast<std::size_t>(3 * corner[static_cast<std::size_t>(i)] + 1)]; };
    ASSERT_GT((x(1) - x(0)) * (y(2) - y(0)) - (x(2) - x(0)) * (y(1) - y(0)), 0.0F);
  }
  ASSERT_TRUE(file);
  file.get();
  EXPECT_TRUE(file.eof());
  EXPECT_NEAR(points[2], scan_->surfaceHeight(points[0], points[1]), 1e-6);
}

TEST_F(TruthWriter, WritesASceneThatMakesTheSameScan)
{
  writeTruth(*scan_, (folder_ / "a.truth").string());
  const SimulatedScan again(loadScene((folder_ / "a.truth" / "scene.yaml").string()));
  std::vector<std::uint8_t> first, second;
  scan_->render(2, first);
  again.render(2, second);
  EXPECT_TRUE(first == second);
}

TEST_F(TruthWriter, ReplacesAnEarlierTruthAndNothingElse)
{
  const fs::path target = folder_ / "a.truth";
  writeTruth(*scan_, target.string());
  std::ofstream(target / "left_over") << "x";
  writeTruth(*scan_, target.string());
  EXPECT_FALSE(fs::exists(target / "left_over"));
  fs::create_directory(folder_ / "mine");
  EXPECT_THROW(writeTruth(*scan_, (folder_ / "mine").string()), InputError);
  EXPECT_TRUE(fs::exists(folder_ / "mine"));
}

TEST_F(TruthWriter, LeavesNothingBehindWhenItCannotWrite)
{
  EXPECT_THROW(writeTruth(*scan_, (folder_ / "no" / "such").string()), InputError);
  EXPECT_TRUE(fs::is_empty(folder_));
}
}  // namespace
}  // namespace weld_profiler
