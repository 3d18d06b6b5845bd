#include "tools/progress.h"

#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <utility>

#include "tools/run_command.h"

namespace weld_profiler
{
namespace
{
constexpr std::size_t kBarWidth = 40;
constexpr std::chrono::milliseconds kRedrawInterval{ 100 };
}  // namespace

Progress::Progress(std::string label, std::size_t total)
  : label_(std::move(label)), total_(total), terminal_(isatty(STDERR_FILENO) == 1)
{
  if (terminal_)
    draw();
}

Progress::~Progress()
{
  if (terminal_)
    erase();
}

void Progress::step()
{
  throwIfInterrupted();
  ++done_;
  const auto now = std::chrono::steady_clock::now();
  if (!terminal_ || now - drawn_ < kRedrawInterval)
    return;
  drawn_ = now;
  draw();
}

void Progress::say(const std::string& line)
{
  if (terminal_)
    erase();
  std::cerr << line << std::endl;
  if (terminal_)
    draw();
}

void Progress::draw() const
{
  const std::size_t filled = total_ == 0 ? 0 : std::min(done_, total_) * kBarWidth / total_;
  std::cerr << "\r" << label_ << " [" << std::string(filled, '#') << std::string(kBarWidth - filled, '.') << "] "
            << done_ << "/" << total_ << std::flush;
}

void Progress::erase() const
{
  const std::size_t width = label_.size() + kBarWidth + 2 * std::to_string(total_).size() + 6;
  std::cerr << "\r" << std::string(width, ' ') << "\r" << std::flush;
}
}  // namespace weld_profiler
