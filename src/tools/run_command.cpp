#include "tools/run_command.h"

#include <csignal>
#include <iostream>
#include <new>
#include <string>

#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
namespace
{
volatile std::sig_atomic_t interrupted = 0;

void onSignal(int /*signal*/)
{
  interrupted = 1;
}

std::string oneLine(std::string text)
{
  while (!text.empty() && (text.back() == '\n' || text.back() == ' '))
    text.pop_back();
  for (char& c : text)
    if (c == '\n' || c == '\r')
      c = ' ';
  return text;
}

int fail(const CommandLine& command, const std::string& text, int status)
{
  std::cerr << command.name() << ": " << oneLine(text) << std::endl;
  return status;
}
}  // namespace

void throwIfInterrupted()
{
  if (interrupted != 0)
    throw Interrupted();
}

void runInterruptible(const std::function<void()>& step)
{
  try
  {
    step();
  }
  catch (const InputError&)
  {
    throwIfInterrupted();
    throw;
  }
}

int runCommand(CommandLine& command, int argc, const char* const* argv, const std::function<int()>& body)
{
  std::signal(SIGINT, onSignal);
  std::signal(SIGTERM, onSignal);
  std::signal(SIGXFSZ, SIG_IGN);  // a file size limit is then a write error like a full disk
  try
  {
    return command.parse(argc, argv) ? body() : kGood;
  }
  catch (const UsageError& error)
  {
    return fail(command, error.what(), kUsage);
  }
  catch (const Interrupted& error)
  {
    return fail(command, error.what(), kInterrupted);
  }
  catch (const std::bad_alloc&)
  {
    return fail(command, "out of memory", kBadInput);
  }
  catch (const std::exception& error)
  {
    return fail(command, error.what(), kBadInput);
  }
}
}  // namespace weld_profiler
