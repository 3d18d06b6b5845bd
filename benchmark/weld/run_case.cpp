#include "weld/run_case.h"

#include <algorithm>
#include <ctime>
#include <mutex>
#include <shared_mutex>

#include "tools/simulated_cloud.h"
#include "weld/compare_sections.h"
#include "weld/compare_spots.h"
#include "weld_profiler/simulation/random_welds.h"
#include "weld_profiler/weld/live_weld.h"
#include "weld_profiler/weld/weld_measurer.h"

namespace weld_profiler
{
namespace weld_accuracy
{
namespace
{
constexpr int kRepeats = 3;  // the fastest counts: what else runs on the machine only adds
constexpr std::array<double, 8> kThicknesses = { 2e-3, 3e-3, 4e-3, 5e-3, 6e-3, 8e-3, 10e-3, 14e-3 };

/// Thickness and question for the verdict, one after the other; the scenes have no thickness.
Judging judgingOf(const SimulatedScan& simulated)
{
  const std::uint64_t turn = simulated.scene().seed / 3;
  return Judging{ simulated.scene().weld.kind, kThicknesses[turn % kThicknesses.size()],
                  turn / kThicknesses.size() % 2 == 1 };
}

WeldJudge judgeOf(const Judging& judging)
{
  VerdictParams params;
  params.thickness = judging.thickness;
  params.judge_toe_angle = judging.toe_angle;
  return WeldJudge(params);
}

/// Held alone while something is timed, shared by all other work: on a core that is two threads' each is slower while
/// both run.
std::shared_mutex& quiet()
{
  static std::shared_mutex mutex;
  return mutex;
}

WeldResult measure(const WeldMeasurer& measurer, const Scan& scan, Times& times)
{
  const std::unique_lock<std::shared_mutex> alone(quiet());
  WeldResult result;
  for (int i = 0; i < kRepeats; ++i)
  {
    const double begin = processorMs();
    result = measurer.measure(scan);
    const double took = processorMs() - begin;
    times.measure = i == 0 ? took : std::min(times.measure, took);
  }
  return result;
}

void measureRows(const WeldMeasurer& measurer, const Scan& scan, Times& times)
{
  const std::unique_lock<std::shared_mutex> alone(quiet());
  double sum = 0.0;
  times.row_worst = 0.0;
  LiveWeld live(measurer);
  for (const Profile& row : scan.rows)
  {
    double best = 0.0;
    for (int i = 0; i < kRepeats; ++i)
    {
      const double begin = processorMs();
      live.measure(row);
      const double took = processorMs() - begin;
      best = i == 0 ? took : std::min(best, took);
    }
    sum += best;
    times.row_worst = std::max(times.row_worst, best);
  }
  times.row_mean = sum / static_cast<double>(scan.rows.size());
}
}  // namespace

double processorMs()
{
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

void timeAgain(WeldCase& weld)
{
  const Scan scan = simulatedCloud(SimulatedScan(randomWeldScene(weld.seed)));
  const WeldMeasurer measurer;
  Times again;
  measure(measurer, scan, again);
  measureRows(measurer, scan, again);
  weld.times.measure = std::min(weld.times.measure, again.measure);
  weld.times.row_mean = std::min(weld.times.row_mean, again.row_mean);
  weld.times.row_worst = std::min(weld.times.row_worst, again.row_worst);
}

WeldCase runCase(std::uint64_t seed)
{
  std::shared_lock<std::shared_mutex> beside(quiet());
  const SimulatedScan simulated(randomWeldScene(seed));
  const Scan scan = simulatedCloud(simulated);
  const WeldMeasurer measurer;
  WeldCase weld;
  beside.unlock();
  const WeldResult result = measure(measurer, scan, weld.times);
  measureRows(measurer, scan, weld.times);
  beside.lock();

  const Judging judging = judgingOf(simulated);
  const WeldJudge judge = judgeOf(judging);
  const MeasuredWeld measured{ simulated, scan, result, judge, judging };
  weld.seed = seed;
  weld.kind = judging.kind;
  weld.measured_kind = name(result.kind);
  weld.thickness = judging.thickness;
  weld.judge_toe_angle = judging.toe_angle;
  weld.rows = static_cast<int>(scan.rows.size());
  weld.cells = static_cast<int>(scan.cells);
  const std::vector<WeldTruth> truths = simulated.weldSections();
  if (!truths.empty())
  {
    weld.width = truths[truths.size() / 2].width;
    weld.reinforcement = truths[truths.size() / 2].reinforcement;
  }
  weld.sections = compareSections(measured);
  weld.shares = compareShares(measured, weld.sections);
  weld.volumes = compareVolumes(measured, weld.sections);
  weld.labels = compareLabels(measured);
  weld.spots = compareSpots(measured);
  return weld;
}
}  // namespace weld_accuracy
}  // namespace weld_profiler
