#include "weld_profiler/scan/export.h"

#include <string>

#include <gtest/gtest.h>

#include "geometry/temporary_folder.h"
#include "scan/small_disk.h"
#include "scan/some_scan.h"
#include "weld_profiler/core/errors.h"

using namespace weld_profiler;

namespace
{
Scan bigScan()
{
  Scan scan = someScan();
  const Profile row = scan.rows[2];
  scan.rows.resize(5000, row);
  return scan;
}

std::string errorOf(const Scan& scan, const std::string& path, const std::string& format)
{
  try
  {
    saveScan(scan, path, format);
  }
  catch (const Error& error)
  {
    return error.what();
  }
  return "";
}

class EveryFormat : public ::testing::TestWithParam<std::string>
{
};
}  // namespace

TEST_P(EveryFormat, GivesTheSameBytesForTheSameScan)
{
  const TemporaryFolder folder;
  saveScan(someScan(), folder.file("first"), GetParam());
  saveScan(bigScan(), folder.file("between"), GetParam());
  saveScan(someScan(), folder.file("second"), GetParam());
  EXPECT_EQ(readText(folder.file("first")), readText(folder.file("second")));
  EXPECT_GT(readText(folder.file("first")).size(), 100u);
  EXPECT_EQ(folder.entries(), 3u) << "no temporary file is left";
}

TEST_P(EveryFormat, NamesPathAndCauseOfAnUnwritableFolder)
{
  const std::string error = errorOf(someScan(), "/nonexistent/scan", GetParam());
  EXPECT_NE(error.find("/nonexistent/scan"), std::string::npos) << error;
  EXPECT_NE(error.find("No such file or directory"), std::string::npos) << error;
}

TEST_P(EveryFormat, LeavesNothingOnAFullDisk)
{
  const TemporaryFolder folder;
  const Scan scan = bigScan();
  for (const unsigned room : { 0u, 100u, 5000u, 100000u })
  {
    writeText(folder.file("scan"), "earlier");
    std::string error;
    ::testing::internal::CaptureStderr();
    {
      const SmallDisk disk(room);
      error = errorOf(scan, folder.file("scan"), GetParam());
    }
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), "") << "said once, by the exception";
    EXPECT_NE(error.find(folder.file("scan")), std::string::npos) << room << ": " << error;
    EXPECT_EQ(readText(folder.file("scan")), "earlier");
    EXPECT_EQ(folder.entries(), 1u);
  }
}

TEST_P(EveryFormat, RefusesAScanWithoutARow)
{
  const TemporaryFolder folder;
  EXPECT_NE(errorOf(Scan{}, folder.file("scan"), GetParam()).find("no row"), std::string::npos);
  EXPECT_EQ(folder.entries(), 0u);
}

INSTANTIATE_TEST_SUITE_P(Known, EveryFormat, ::testing::ValuesIn(scanFormats()),
                         [](const auto& info) { return info.param; });

TEST(SaveScan, ListsTheFormatsItKnows)
{
  const TemporaryFolder folder;
  const std::string error = errorOf(someScan(), folder.file("scan.xyz"), "xyz");
  EXPECT_NE(error.find("'xyz'"), std::string::npos) << error;
  EXPECT_NE(error.find("pcd, ply, csv"), std::string::npos) << error;
  EXPECT_EQ(folder.entries(), 0u);
}
