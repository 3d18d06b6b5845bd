#include <cmath>
#include <cstring>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <pcl/PCLPointCloud2.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>

#include "geometry/temporary_folder.h"
#include "scan/some_scan.h"
#include "weld_profiler/core/errors.h"
#include "weld_profiler/scan/cloud_record.h"
#include "weld_profiler/scan/export.h"

using namespace weld_profiler;

namespace
{
float field(const pcl::PCLPointCloud2& cloud, std::size_t point, const std::string& name)
{
  for (const auto& f : cloud.fields)
    if (f.name == name)
    {
      const auto* at = cloud.data.data() + point * cloud.point_step + f.offset;
      float value = 0.0F;
      if (f.datatype == pcl::PCLPointField::UINT8)
        return static_cast<float>(*at);
      std::memcpy(&value, at, sizeof(value));
      return value;
    }
  ADD_FAILURE() << "no field " << name;
  return 0.0F;
}
}  // namespace

TEST(SavedPcd, IsReadByPclAsTheOrganisedCloud)
{
  const TemporaryFolder folder;
  saveScan(someScan(), folder.file("scan.pcd"), "pcd");
  pcl::PCLPointCloud2 cloud;
  ASSERT_EQ(pcl::io::loadPCDFile(folder.file("scan.pcd"), cloud), 0);
  EXPECT_EQ(cloud.width, 5u);
  EXPECT_EQ(cloud.height, 3u);
  EXPECT_EQ(cloud.point_step, 32u);
  std::size_t i = 0;
  for (const CloudField& expected : kCloudFields)
  {
    ASSERT_LT(i, cloud.fields.size());
    EXPECT_EQ(cloud.fields[i].name, expected.name);
    EXPECT_EQ(cloud.fields[i].offset, expected.offset);
    EXPECT_EQ(cloud.fields[i].datatype, expected.is_float ? pcl::PCLPointField::FLOAT32 : pcl::PCLPointField::UINT8);
    ++i;
  }
  EXPECT_EQ(i, 8u);
  EXPECT_EQ(field(cloud, 4, "x"), 0.2F);
  EXPECT_EQ(field(cloud, 4, "y"), 0.25F);
  EXPECT_EQ(field(cloud, 4, "z"), 0.31F);
  EXPECT_EQ(field(cloud, 4, "intensity"), 41.0F);
  EXPECT_EQ(field(cloud, 4, "sigma"), 2e-5F);
  EXPECT_EQ(field(cloud, 4, "stage"), 0.25F);
  EXPECT_EQ(field(cloud, 4, "time"), 0.0F);
  EXPECT_EQ(field(cloud, 4, "flags"), 2.0F);
  EXPECT_EQ(field(cloud, 12, "z"), 0.34F);
  EXPECT_EQ(field(cloud, 12, "time"), 0.1F) << "since the first row";
}

TEST(SavedPcd, HasNanInItsHolesAndTheRowsStageAndTime)
{
  const TemporaryFolder folder;
  saveScan(someScan(), folder.file("scan.pcd"), "pcd");
  pcl::PCLPointCloud2 cloud;
  ASSERT_EQ(pcl::io::loadPCDFile(folder.file("scan.pcd"), cloud), 0);
  int holes = 0;
  for (std::size_t i = 0; i < 15; ++i)
  {
    if (!std::isnan(field(cloud, i, "z")))
      continue;
    ++holes;
    for (const char* name : { "x", "y", "intensity", "sigma" })
      EXPECT_TRUE(std::isnan(field(cloud, i, name)));
    EXPECT_EQ(field(cloud, i, "flags"), 0.0F);
    EXPECT_EQ(field(cloud, i, "stage"), static_cast<float>(someScan().rows[i / 5].stage));
  }
  EXPECT_EQ(holes, 10);
}

TEST(SavedPcd, HoldsItsHeaderAndItsRecordsAndNothingElse)
{
  const TemporaryFolder folder;
  saveScan(someScan(), folder.file("scan.pcd"), "pcd");
  const std::string text = readText(folder.file("scan.pcd"));
  const std::string marker = "DATA binary\n";
  const std::size_t data = text.find(marker) + marker.size();
  const std::vector<CloudRecord> records = organisedRecords(someScan());
  ASSERT_EQ(text.size() - data, records.size() * 32);
  EXPECT_EQ(std::memcmp(text.data() + data, records.data(), records.size() * 32), 0);
  EXPECT_NE(text.find("FIELDS x y z intensity sigma stage time flags"), std::string::npos);
  EXPECT_NE(text.find("WIDTH 5\nHEIGHT 3\n"), std::string::npos);
}

TEST(SavedPly, IsReadByPclAsTheValidPoints)
{
  const TemporaryFolder folder;
  saveScan(someScan(), folder.file("scan.ply"), "ply");
  pcl::PCLPointCloud2 cloud;
  ASSERT_EQ(pcl::io::loadPLYFile(folder.file("scan.ply"), cloud), 0);
  ASSERT_EQ(cloud.width * cloud.height, 5u);
  EXPECT_EQ(field(cloud, 0, "x"), 0.1F);
  EXPECT_EQ(field(cloud, 1, "z"), 0.31F);
  EXPECT_EQ(field(cloud, 4, "sigma"), 5e-5F);
  EXPECT_EQ(field(cloud, 4, "time"), 0.1F);
  EXPECT_EQ(field(cloud, 2, "flags"), 5.0F);
}

TEST(SavedPly, HasNoVertexWhenNoFrameShowedAStripe)
{
  const TemporaryFolder folder;
  Scan scan = someScan();
  for (Profile& row : scan.rows)
    row.points.clear();
  saveScan(scan, folder.file("scan.ply"), "ply");
  const std::string text = readText(folder.file("scan.ply"));
  EXPECT_NE(text.find("element vertex 0\nproperty float x\n"), std::string::npos) << text;
  EXPECT_EQ(text.substr(text.size() - 11), "end_header\n");
}

TEST(SavedCsv, IsALineAPointInMetres)
{
  const TemporaryFolder folder;
  saveScan(someScan(), folder.file("scan.csv"), "csv");
  std::istringstream lines(readText(folder.file("scan.csv")));
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "row,cell,x_m,y_m,z_m,intensity,sigma_m,stage_m,time_s,flags");
  std::getline(lines, line);
  std::getline(lines, line);
  EXPECT_EQ(line, "0,4,0.200000003,0.25,0.310000002,41,1.99999995e-05,0.25,0,2");
  int rest = 0;
  while (std::getline(lines, line))
    ++rest;
  EXPECT_EQ(rest, 3);
}

TEST(SavedClouds, HoldTheirCommentsAndAreReadAllTheSame)
{
  const TemporaryFolder folder;
  const std::vector<std::string> comments = { "weld K-17", "calibration 0123456789abcdef", "" };
  for (const std::string format : { "pcd", "ply" })
  {
    const std::string path = folder.file("scan." + format);
    saveScan(someScan(), path, format, comments);
    const std::string head = readText(path).substr(0, 200);
    const std::string mark = format == "pcd" ? "\n# " : "\ncomment ";
    EXPECT_NE(head.find(mark + comments[0] + mark + comments[1] + mark), std::string::npos) << head;
    pcl::PCLPointCloud2 cloud;
    ASSERT_EQ(format == "pcd" ? pcl::io::loadPCDFile(path, cloud) : pcl::io::loadPLYFile(path, cloud), 0);
    EXPECT_EQ(field(cloud, format == "pcd" ? 4 : 1, "z"), 0.31F);
    EXPECT_THROW(saveScan(someScan(), path, format, { "two\nlines" }), PreconditionError);
    EXPECT_EQ(readText(path).substr(0, 200), head) << "the file stays";
  }
}
