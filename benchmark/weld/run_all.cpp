#include "weld/run_all.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <filesystem>
#include <mutex>
#include <optional>
#include <thread>

#include "weld/case_file.h"
#include "weld/run_case.h"
#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
namespace weld_accuracy
{
namespace
{
constexpr std::size_t kTimedAgain = 20;  // one in so many, the slowest by the row

class Worker
{
public:
  Worker(const Selection& run, const Progress& progress) : run_(run), progress_(progress), mark_(buildMark())
  {
    if (run.state.empty())
      return;
    std::error_code error;
    std::filesystem::create_directories(run.state, error);
    if (!std::filesystem::is_directory(run.state))
      throw InputError(run.state + ": cannot be made a folder, name another with --state");
  }

  std::vector<WeldCase> operator()()
  {
    welds_.resize(static_cast<std::size_t>(run_.welds));
    std::vector<std::thread> threads;
    for (int i = 0; i < std::clamp(run_.threads, 1, 2); ++i)
      threads.emplace_back([this] { work(); });
    for (std::thread& thread : threads)
      thread.join();
    if (failure_)
      std::rethrow_exception(failure_);
    timeSlowestAgain();
    return std::move(welds_);
  }

private:
  std::string pathOf(std::uint64_t seed) const
  {
    return run_.state.empty() ? "" : run_.state + "/weld_" + std::to_string(seed) + ".txt";
  }

  /// A machine that others share is slower for minutes at a time: the slowest have a second chance.
  void timeSlowestAgain()
  {
    std::vector<WeldCase*> slowest;
    for (WeldCase& weld : welds_)
      slowest.push_back(&weld);
    std::sort(slowest.begin(), slowest.end(),
              [](const WeldCase* a, const WeldCase* b)
              { return a->times.measure * b->rows > b->times.measure * a->rows; });
    slowest.resize(slowest.size() / kTimedAgain);
    for (WeldCase* weld : slowest)
    {
      timeAgain(*weld);
      if (!run_.state.empty())
        saveCase(*weld, pathOf(weld->seed), mark_);
    }
  }

  void work()
  {
    for (int i = next_++; i < run_.welds && !failed_; i = next_++)
    {
      try
      {
        take(i);
      }
      catch (...)
      {
        const std::lock_guard<std::mutex> lock(mutex_);
        failure_ = failure_ ? failure_ : std::current_exception();
        failed_ = true;
      }
    }
  }

  void take(int index)
  {
    const std::uint64_t seed = run_.first + static_cast<std::uint64_t>(index);
    const std::string path = pathOf(seed);
    std::optional<WeldCase> weld = path.empty() ? std::nullopt : loadCase(path, mark_);
    const bool is_new = !weld;
    if (is_new)
      weld = runCase(seed);
    if (is_new && !path.empty())
      saveCase(*weld, path, mark_);
    const std::lock_guard<std::mutex> lock(mutex_);
    welds_[static_cast<std::size_t>(index)] = std::move(*weld);
    progress_(welds_[static_cast<std::size_t>(index)], ++done_);
  }

  const Selection& run_;
  const Progress& progress_;
  const std::string mark_;
  std::vector<WeldCase> welds_;
  std::atomic<int> next_{ 0 };
  std::atomic<bool> failed_{ false };
  std::mutex mutex_;
  std::exception_ptr failure_;
  int done_ = 0;
};
}  // namespace

std::vector<WeldCase> runAll(const Selection& run, const Progress& progress)
{
  return Worker(run, progress)();
}
}  // namespace weld_accuracy
}  // namespace weld_profiler
