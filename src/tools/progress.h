#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace weld_profiler
{
/// How far a long command is, on standard error: a bar on a terminal, nothing in a pipe or file.
class Progress
{
public:
  /// @param label  what is being done, e.g. "rendering".
  /// @param total  number of steps.
  Progress(std::string label, std::size_t total);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// One more step is done. @throws Interrupted when the user pressed Ctrl-C, so that temporary files are removed.
  void step();

  /// Prints a line on standard error without tearing the bar.
  void say(const std::string& line);

private:
  void draw() const;
  void erase() const;

  std::string label_;
  std::size_t total_;
  std::size_t done_ = 0;
  bool terminal_;
  std::chrono::steady_clock::time_point drawn_;
};
}  // namespace weld_profiler
