#pragma once

#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace weld_profiler
{
/// What a command did.
struct CommandResult
{
  int status = -1;
  std::string output;  ///< standard output
  std::string errors;  ///< standard error

  std::ptrdiff_t errorLines() const { return std::count(errors.begin(), errors.end(), '\n'); }
  bool says(const std::string& text) const { return errors.find(text) != std::string::npos; }
};

inline std::string readText(const std::filesystem::path& path)
{
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// A test in its own empty directory, which is where the commands run. No ROS master is there, and none is needed.
class CommandTest : public ::testing::Test
{
protected:
  void SetUp() override
  {
    char name[] = "/tmp/weld_profiler_command.XXXXXX";
    ASSERT_NE(mkdtemp(name), nullptr);
    folder_ = name;
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  /// Runs `command arguments` through the shell. @param setup  what the shell does first, e.g. a limit.
  CommandResult run(const std::string& command, const std::string& arguments, const std::string& setup = ":") const
  {
    const std::string line = "cd '" + folder_.string() + "' && unset ROS_MASTER_URI && " + setup + " && '" +
                             WELD_PROFILER_COMMANDS "/" + command + "' " + arguments +
                             " > .output 2> .errors < /dev/null";
    const int status = std::system(("bash -c \"" + line + "\"").c_str());
    const CommandResult result{ WIFEXITED(status) ? WEXITSTATUS(status) : -1, readText(folder_ / ".output"),
                                readText(folder_ / ".errors") };
    std::filesystem::remove(folder_ / ".output");
    std::filesystem::remove(folder_ / ".errors");
    return result;
  }

  /// Names in a directory of the test's, sorted, hidden ones included: what a command left behind.
  std::vector<std::string> filesIn(const std::string& directory) const
  {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder_ / directory))
      names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
  }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string text(const std::string& name) const { return readText(folder_ / name); }
  void write(const std::string& name, const std::string& content) const { std::ofstream(path(name)) << content; }

  std::filesystem::path folder_;
};
}  // namespace weld_profiler
