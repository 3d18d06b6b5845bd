#include "weld_profiler/core/atomic_file.h"

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "geometry/temporary_folder.h"
#include "scan/small_disk.h"

using namespace weld_profiler;

namespace
{
/// The error that writing gives; empty when it is written.
std::string errorOf(const std::string& path, const std::string& content = "new")
{
  try
  {
    writeWholeFile(path, content);
  }
  catch (const InputError& error)
  {
    return error.what();
  }
  return "";
}
}  // namespace

TEST(AtomicFile, AppearsWithCommitAndNotBefore)
{
  const TemporaryFolder folder;
  {
    AtomicFile file(folder.file("a.txt"));
    file.write("old words");
    file.write("words");
    EXPECT_FALSE(std::filesystem::exists(folder.file("a.txt")));
    EXPECT_EQ(readText(file.temporaryPath()), "words");
    file.commit();
  }
  EXPECT_EQ(readText(folder.file("a.txt")), "words");
  EXPECT_EQ(folder.entries(), 1u);
}

TEST(AtomicFile, LeavesNothingWithoutCommit)
{
  const TemporaryFolder folder;
  {
    AtomicFile file(folder.file("a.txt"));
    file.write("words");
  }
  EXPECT_EQ(folder.entries(), 0u);
}

TEST(AtomicFile, LeavesAnEarlierFileUntilCommit)
{
  const TemporaryFolder folder;
  writeText(folder.file("a.txt"), "earlier");
  {
    AtomicFile file(folder.file("a.txt"));
    file.write("words");
    EXPECT_EQ(readText(folder.file("a.txt")), "earlier");
  }
  EXPECT_EQ(readText(folder.file("a.txt")), "earlier");
  EXPECT_EQ(errorOf(folder.file("a.txt")), "");
  EXPECT_EQ(readText(folder.file("a.txt")), "new");
}

TEST(AtomicFile, NamesPathAndCauseWhenTheFolderIsAbsent)
{
  const std::string error = errorOf("/nonexistent/deep/a.txt");
  EXPECT_NE(error.find("/nonexistent/deep/a.txt"), std::string::npos) << error;
  EXPECT_NE(error.find("No such file or directory"), std::string::npos) << error;
}

TEST(AtomicFile, RefusesFoldersDevicesAndNoName)
{
  const TemporaryFolder folder;
  EXPECT_NE(errorOf("/dev/full").find("not a regular file"), std::string::npos);
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
  std::filesystem::create_directory(folder.file("sub"));
  EXPECT_NE(errorOf(folder.file("sub")).find("not a regular file"), std::string::npos);
  EXPECT_NE(errorOf(folder.file("sub/")), "");
  EXPECT_NE(errorOf(""), "");
  EXPECT_EQ(folder.entries(), 1u);
}

TEST(AtomicFile, LeavesNothingOnAFullDisk)
{
  const TemporaryFolder folder;
  writeText(folder.file("a.txt"), "earlier");
  std::string error;
  {
    const SmallDisk disk(1000);
    error = errorOf(folder.file("a.txt"), std::string(100000, 'x'));
  }
  EXPECT_NE(error.find("File too large"), std::string::npos) << error;
  EXPECT_NE(error.find(folder.file("a.txt")), std::string::npos) << error;
  EXPECT_EQ(readText(folder.file("a.txt")), "earlier");
  EXPECT_EQ(folder.entries(), 1u);
}

TEST(AtomicFile, WritesThroughALink)
{
  const TemporaryFolder folder;
  writeText(folder.file("a.txt"), "earlier");
  std::filesystem::create_symlink("a.txt", folder.file("link.txt"));
  EXPECT_EQ(errorOf(folder.file("link.txt")), "");
  EXPECT_TRUE(std::filesystem::is_symlink(folder.file("link.txt")));
  EXPECT_EQ(readText(folder.file("a.txt")), "new");
}

TEST(AtomicFile, TakesANameInTheWorkingFolder)
{
  const TemporaryFolder folder;
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(folder.file(""));
  EXPECT_EQ(errorOf("a.txt"), "");
  std::filesystem::current_path(before);
  EXPECT_EQ(readText(folder.file("a.txt")), "new");
}
