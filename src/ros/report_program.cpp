#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "weld_profiler/core/errors.h"
#include "weld_profiler/ros/calibration_url.h"
#include "weld_profiler/ros/weld_files.h"

namespace weld_profiler
{
namespace
{
const char* const kWeldReport = "package://weld_profiler/scripts/weld_report.py";
const char* const kCompareReport = "package://weld_profiler/scripts/compare_report.py";

constexpr int kInterrupted = 130;

/// For a shell: in single quotes, those inside closed, escaped and opened again.
std::string quoted(const std::string& word)
{
  std::string text = "'";
  for (const char c : word)
    text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}
/// @param more  further words for the shell.
std::vector<std::string> runProgram(const char* program, const std::string& directory, const std::string& more)
{
  // exec: no shell between that takes an interrupt for itself
  const std::string command =
      "exec /usr/bin/python3 " + quoted(resolveUrl(program)) + " " + more + quoted(directory) + " 2>&1";
  std::FILE* pipe = ::popen(command.c_str(), "r");
  if (pipe == nullptr)
    throw InputError("cannot start the report program for " + directory + ", is python3 installed?");
  std::string said;
  std::array<char, 512> buffer{};
  while (std::fgets(buffer.data(), static_cast<int>(buffer.size()), pipe) != nullptr)
    said += buffer.data();
  const int status = ::pclose(pipe);
  if (status != -1 && (WIFSIGNALED(status) || WEXITSTATUS(status) == kInterrupted))
    throw InputError("no report of " + directory + ": interrupted");
  if (status == -1 || !WIFEXITED(status) || WEXITSTATUS(status) != 0)
    throw InputError("no report of " + directory + ": " + said.substr(0, said.find('\n')));
  std::vector<std::string> files;
  for (const char* name : { "report.html", "report.png" })
    files.push_back((std::filesystem::path(directory) / name).string());
  return files;
}
}  // namespace

std::vector<std::string> writeReport(const std::string& directory)
{
  return runProgram(kWeldReport, directory, "");
}

std::vector<std::string> writeCompareReport(const std::string& directory, const std::string& named)
{
  return runProgram(kCompareReport, directory, "--named=" + quoted(named) + " ");
}
}  // namespace weld_profiler
