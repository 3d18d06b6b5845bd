#pragma once

#include <functional>
#include <stdexcept>
#include <string>

#include "tools/command_line.h"

namespace weld_profiler
{
/// Exit statuses of every command.
enum ExitStatus
{
  kGood = 0,
  kBadInput = 1,  ///< one line on standard error names the file, the cause and what to do; no partial output
  kUsage = 2,
  kPoorResult = 3,  ///< ran, but the result is poor: files kept, said so
  kInterrupted = 130
};

/// Ctrl-C or SIGTERM: unwinds, so that temporary files are removed.
class Interrupted : public std::runtime_error
{
public:
  /// @param left  what the command leaves: the user is told.
  explicit Interrupted(const std::string& left = "nothing was written") : std::runtime_error("interrupted, " + left) {}
};

/// @throws Interrupted once SIGINT or SIGTERM came in.
void throwIfInterrupted();

/// Runs what starts another program. Who interrupts at a terminal interrupts that one too, and it is no fault of
/// either.
/// @throws Interrupted instead of an InputError once SIGINT or SIGTERM came in.
void runInterruptible(const std::function<void()>& step);

/// Reads the command line, runs the body and maps what it throws to an exit status and one line on standard error:
/// UsageError -> 2, any other exception -> 1. Needs no ROS master.
/// @param body  returns an ExitStatus.
int runCommand(CommandLine& command, int argc, const char* const* argv, const std::function<int()>& body);
}  // namespace weld_profiler
