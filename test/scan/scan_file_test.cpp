#include "weld_profiler/scan/scan_file.h"

#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>

#include <gtest/gtest.h>
#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include "support/temporary_folder.h"
#include "weld_profiler/core/errors.h"
#include "weld_profiler/scan/export.h"
#include "weld_profiler/scan/float_maps.h"
#include "weld_profiler/scan/labelled_scan.h"

namespace weld_profiler
{
namespace
{
Scan someScan()
{
  Scan scan;
  scan.cells = 4;
  for (int row = 0; row < 3; ++row)
  {
    Profile profile;
    profile.cells = 4;
    profile.stage = 0.25 * row;
    profile.stamp = 50000000 * row;
    for (const int cell : { 0, 1, 3 })
    {
      CloudPoint point;
      point.x = 0.01F * static_cast<float>(cell), point.y = 0.5F * static_cast<float>(row), point.z = 0.125F;
      point.intensity = 80.0F + static_cast<float>(cell);
      point.sigma = 3e-6F;
      point.cell = static_cast<std::uint16_t>(cell);
      point.flags = static_cast<std::uint8_t>(row == 1 && cell == 3 ? 1 : 0);
      profile.points.push_back(point);
    }
    scan.rows.push_back(profile);
  }
  return scan;
}

void expectSame(const Scan& read, const Scan& scan)
{
  EXPECT_EQ(read.cells, scan.cells);
  ASSERT_EQ(read.rows.size(), scan.rows.size());
  for (std::size_t row = 0; row < scan.rows.size(); ++row)
  {
    EXPECT_NEAR(read.rows[row].stage, scan.rows[row].stage, 1e-7);
    EXPECT_NEAR(static_cast<double>(read.rows[row].stamp), static_cast<double>(scan.rows[row].stamp), 10.0);
    EXPECT_EQ(read.rows[row].cells, scan.cells);
    ASSERT_EQ(read.rows[row].points.size(), scan.rows[row].points.size());
    for (std::size_t i = 0; i < scan.rows[row].points.size(); ++i)
    {
      const CloudPoint &a = read.rows[row].points[i], &b = scan.rows[row].points[i];
      EXPECT_EQ(a.x, b.x);
      EXPECT_EQ(a.y, b.y);
      EXPECT_EQ(a.z, b.z);
      EXPECT_EQ(a.intensity, b.intensity);
      EXPECT_EQ(a.sigma, b.sigma);
      EXPECT_EQ(a.cell, b.cell);
      EXPECT_EQ(a.flags, b.flags);
    }
  }
}

class ScanFile : public ::testing::Test
{
protected:
  std::string path(const std::string& name) const { return folder_.file(name); }
  std::string content(const std::string& name) const
  {
    std::ifstream file(path(name), std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
  }
  void write(const std::string& name, const std::string& text) const
  {
    std::ofstream(path(name), std::ios::binary) << text;
  }
  void expectRefused(const std::string& name, const std::string& words) const
  {
    try
    {
      loadScan(path(name));
      ADD_FAILURE() << name << " was read";
    }
    catch (const InputError& error)
    {
      EXPECT_EQ(std::string(error.what()).find(path(name)), 0u) << error.what();
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  }
  TemporaryFolder folder_;
};
}  // namespace

TEST_F(ScanFile, GivesBackWhatWasSaved)
{
  saveScan(someScan(), path("scan.pcd"), "pcd");
  expectSame(loadScan(path("scan.pcd")), someScan());
  saveLabelledScan(someScan(), { {}, {} }, path("weld_points.pcd"));
  expectSame(loadScan(path("weld_points.pcd")), someScan());
}

TEST_F(ScanFile, ReadsAsciiAndCompressedCloudsOfOtherPrograms)
{
  pcl::PointCloud<pcl::PointXYZ> cloud(5, 3);
  for (std::size_t i = 0; i < cloud.size(); ++i)
    cloud.points[i] = pcl::PointXYZ(0.001F * static_cast<float>(i % 5), 0.001F * static_cast<float>(i / 5), 0.5F);
  cloud.points[7].z = std::numeric_limits<float>::quiet_NaN();
  pcl::io::savePCDFileASCII(path("ascii.pcd"), cloud);
  pcl::io::savePCDFileBinaryCompressed(path("compressed.pcd"), cloud);
  for (const char* name : { "ascii.pcd", "compressed.pcd" })
  {
    const Scan scan = loadScan(path(name));
    EXPECT_EQ(scan.cells, 5u) << name;
    ASSERT_EQ(scan.rows.size(), 3u) << name;
    EXPECT_EQ(scan.rows[0].points.size(), 5u) << name;
    EXPECT_EQ(scan.rows[1].points.size(), 4u) << name << ": a hole is no point";
    EXPECT_FLOAT_EQ(scan.rows[2].points[3].x, 0.003F) << name;
    EXPECT_FLOAT_EQ(scan.rows[2].points[3].sigma, 1e-5F) << name << ": it tells none";
  }
}

TEST_F(ScanFile, RefusesWhatIsNoOrganisedCloud)
{
  expectRefused("nowhere.pcd", "no such file");
  std::filesystem::create_directory(path("folder"));
  expectRefused("folder", "is no file");
  write("text.pcd", "this is no cloud\n");
  expectRefused("text.pcd", "");
  write("empty.pcd", "");
  expectRefused("empty.pcd", "");
  saveScan(someScan(), path("scan.pcd"), "pcd");
  const std::string whole = content("scan.pcd");
  write("cut.pcd", whole.substr(0, whole.size() - 40));
  expectRefused("cut.pcd", "ends before its 12 points do");
  pcl::PointCloud<pcl::PointXYZ> heap(15, 1);
  pcl::io::savePCDFileASCII(path("heap.pcd"), heap);
  expectRefused("heap.pcd", "not organised");
  pcl::PointCloud<pcl::PointXY> flat(5, 3);
  pcl::io::savePCDFileASCII(path("flat.pcd"), flat);
  expectRefused("flat.pcd", "no fields x y z");
}

TEST_F(ScanFile, RefusesAHeaderThatPromisesTheMoon)
{
  saveScan(someScan(), path("scan.pcd"), "pcd");
  std::string text = content("scan.pcd");
  const auto change = [&text](const std::string& from, const std::string& to)
  {
    ASSERT_NE(text.find(from), std::string::npos) << from;
    text.replace(text.find(from), from.size(), to);
  };
  change("WIDTH 4", "WIDTH 2000000000");
  change("HEIGHT 3", "HEIGHT 2");
  change("POINTS 12", "POINTS 4000000000");
  write("moon.pcd", text);
  expectRefused("moon.pcd", "");
}

TEST_F(ScanFile, FloatMapsAreFieldsOfAnOrganisedCloud)
{
  const std::vector<float> x = { 1, 2, 3, 4, 5, 6 }, rest = { 6, 5, std::numeric_limits<float>::quiet_NaN(), 3, 2, 1 };
  saveFloatMaps({ { "x", x }, { "rest", rest } }, 3, path("maps.pcd"));
  pcl::PCLPointCloud2 cloud;
  ASSERT_EQ(pcl::PCDReader().read(path("maps.pcd"), cloud), 0);
  EXPECT_EQ(cloud.width, 3u);
  EXPECT_EQ(cloud.height, 2u);
  ASSERT_EQ(cloud.fields.size(), 2u);
  EXPECT_EQ(cloud.fields[1].name, "rest");
  float value = 0.0F;
  std::memcpy(&value, &cloud.data[5 * cloud.point_step + cloud.fields[1].offset], sizeof(value));
  EXPECT_EQ(value, 1.0F);
  std::memcpy(&value, &cloud.data[2 * cloud.point_step + cloud.fields[1].offset], sizeof(value));
  EXPECT_TRUE(std::isnan(value));
  EXPECT_THROW(saveFloatMaps({ { "x", x }, { "rest", { 1.0F } } }, 3, path("bad.pcd")), PreconditionError);
  EXPECT_THROW(saveFloatMaps({ { "x", x } }, 4, path("bad.pcd")), PreconditionError);
  EXPECT_THROW(saveFloatMaps({ { "x", x } }, 0, path("bad.pcd")), PreconditionError);
  EXPECT_THROW(saveFloatMaps({ { "x", x } }, 3, path("no/folder/maps.pcd")), InputError);
}
}  // namespace weld_profiler
