#include "tools/staged_output.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>

#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
namespace
{
namespace fs = std::filesystem;

class StagedOutputTest : public ::testing::Test
{
protected:
  void SetUp() override
  {
    char name[] = "/tmp/staged_output_test.XXXXXX";
    ASSERT_NE(mkdtemp(name), nullptr);
    folder_ = name;
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::size_t entries() const
  {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }

  fs::path folder_;
};

TEST_F(StagedOutputTest, GivesFileAndDirectoryTheirNamesOnCommit)
{
  StagedOutput output;
  std::ofstream(output.file(path("scan.bag"))) << "bag";
  const std::string truth = output.directory(path("scan.bag.truth"));
  makeOutputDirectory(truth);
  std::ofstream(truth + "/centres.csv") << "truth";
  EXPECT_FALSE(fs::exists(path("scan.bag")));
  output.commit();
  EXPECT_EQ(fs::file_size(path("scan.bag")), 3u);
  EXPECT_EQ(fs::file_size(path("scan.bag.truth/centres.csv")), 5u);
  EXPECT_EQ(entries(), 2u) << "nothing temporary is left";
}

TEST_F(StagedOutputTest, ReplacesWhatWasThere)
{
  for (const char* content : { "first", "second time" })
  {
    StagedOutput output;
    const std::string truth = output.directory(path("truth"));
    makeOutputDirectory(truth);
    std::ofstream(truth + "/" + content) << content;
    output.commit();
  }
  EXPECT_FALSE(fs::exists(path("truth/first")));
  EXPECT_TRUE(fs::exists(path("truth/second time")));
}

TEST_F(StagedOutputTest, LeavesNothingWithoutCommitAndKeepsTheOldFile)
{
  writeFileWhole(path("scan.bag"), "old");
  {
    StagedOutput output;
    std::ofstream(output.file(path("scan.bag"))) << "half of the new";
    makeOutputDirectory(output.directory(path("truth")));
  }
  EXPECT_EQ(entries(), 1u);
  EXPECT_EQ(fs::file_size(path("scan.bag")), 3u);
}

TEST_F(StagedOutputTest, RefusesTargetsThatCannotBeWritten)
{
  StagedOutput output;
  EXPECT_THROW(output.file(path("nowhere/scan.bag")), InputError);
  EXPECT_THROW(output.file(folder_.string()), InputError);
  EXPECT_THROW(output.file("/proc/scan.bag"), InputError);
  writeFileWhole(path("file"), "x");
  EXPECT_THROW(output.directory(path("file")), InputError);
  EXPECT_THROW(makeOutputDirectory(path("file")), InputError);
  EXPECT_THROW(makeOutputDirectory("/proc/out"), InputError);
}

TEST_F(StagedOutputTest, CreatesADirectoryWithItsParents)
{
  makeOutputDirectory(path("a/b"));
  makeOutputDirectory(path("a/b"));
  EXPECT_TRUE(fs::is_directory(path("a/b")));
}
}  // namespace
}  // namespace weld_profiler
