// How well welds are measured: simulated welds of all kinds through the whole chain, against their exact truth.
// docs/weld-accuracy.md says what counts and what each bar means.
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <exception>

#include "tools/command_line.h"
#include "weld/acceptance.h"
#include "weld/gauge_welds.h"
#include "weld/run_all.h"
#include "weld/tables.h"

namespace weld_profiler
{
namespace weld_accuracy
{
namespace
{
constexpr int kQuick = 24;

struct Options
{
  Selection run;
  int first = 0;
  bool quick = false;
  bool gauge_only = false;
  std::string json;
};

void declare(CommandLine& command, Options& options)
{
  command.option("welds N", options.run.welds, "how many");
  command.option("first SEED", options.first, "seed of the first, the others follow it; kinds take turns");
  command.option("state DIR", options.run.state,
                 "keeps a small file a weld there; a second call of the same build goes on where the first ended");
  command.option("threads N", options.run.threads, "welds at a time, 1 or 2");
  command.option("json FILE", options.json, "writes every number, for scripts/plot_weld_gauge.py too");
  command.flag("quick", options.quick, "24 welds");
  command.flag("gauge-only", options.gauge_only, "the three welds of the gauge figure alone");
  command.example("weld_accuracy --state /tmp/welds --threads 2 --json /tmp/welds.json");
}

void check(Options& options)
{
  if (options.quick)
    options.run.welds = kQuick;
  if (options.run.welds < 1 || options.run.welds > 100000)
    throw UsageError("--welds is " + std::to_string(options.run.welds) + ", must be in 1..100000");
  if (options.first < 0)
    throw UsageError("--first is " + std::to_string(options.first) + ", must be 0 or more");
  if (options.run.threads < 1 || options.run.threads > 2)
    throw UsageError("--threads is " + std::to_string(options.run.threads) + ", must be 1 or 2");
  options.run.first = static_cast<std::uint64_t>(options.first);
}

void showProgress(const WeldCase& weld, int done, int all)
{
  std::fprintf(stderr, "%d of %d: weld %llu, %s, %.0f ms\n", done, all, static_cast<unsigned long long>(weld.seed),
               weld.kind.c_str(), weld.times.measure);
}

int run(const Options& options)
{
  comparison::Report report;
  std::vector<Bar> bars;
  if (!options.gauge_only)
  {
    const std::vector<WeldCase> welds =
        runAll(options.run, [&](const WeldCase& weld, int done) { showProgress(weld, done, options.run.welds); });
    std::printf("%zu welds from seed %d on\n", welds.size(), options.first);
    reportDetails(welds, report);
    bars = acceptanceOf(welds);
    reportBars(bars, report);
  }
  reportGaugeWelds(report);
  if (!bars.empty())
    printBars(bars);
  if (!options.json.empty())
    report.write(options.json);
  return 0;
}
}  // namespace
}  // namespace weld_accuracy
}  // namespace weld_profiler

int main(int argc, char** argv)
{
  using namespace weld_profiler;
  weld_accuracy::Options options;
  CommandLine command("weld_accuracy",
                      "Sends simulated welds through the whole chain, without bags, and compares all that was\n"
                      "measured with the exact truth: one line a bar at the end, met or MISSED.");
  weld_accuracy::declare(command, options);
  try
  {
    if (!command.parse(argc, argv))
      return 0;
    weld_accuracy::check(options);
    return weld_accuracy::run(options);
  }
  catch (const UsageError& error)
  {
    std::fprintf(stderr, "weld_accuracy: %s\n", error.what());
    return 2;
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "weld_accuracy: %s\n", error.what());
    return 1;
  }
}
