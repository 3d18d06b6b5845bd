#include <iostream>

#include "tools/compare_input.h"
#include "tools/compare_output.h"
#include "tools/params_file.h"
#include "tools/run_command.h"
#include "weld_profiler/core/errors.h"
#include "weld_profiler/ros/weld_server.h"

namespace weld_profiler
{
namespace
{
constexpr double kLeastShare = 0.5;  // of the weld; less compared is a poor result
constexpr double kMm = 1e-3;

struct Options
{
  std::string out;
  std::string params;
  std::string weld_id;
  double threshold_mm = 0.05;
  double min_area_mm2 = 0.1;
  double placement_mm = 0.5;
  double placement_turn_deg = 0.5;
  double max_residual_mm = 0.03;
  double max_shift_mm = 10.0;
  double max_turn_deg = 5.0;
  bool no_report = false;
  std::vector<std::string> scans;
};

void declare(CommandLine& command, Options& options)
{
  command.option("out DIR", options.out, "where the files go; created if needed");
  command.required();
  command.option("threshold MM", options.threshold_mm, "over-ground is what lies deeper than this below the target");
  command.option("min-area MM2", options.min_area_mm2, "smaller places are not reported as over-ground");
  command.option(
      "placement MM", options.placement_mm,
      "1 sigma of how exactly the part lay in its old place along the plates; counts where no surface tells");
  command.option("placement-turn DEG", options.placement_turn_deg, "and of its turn in the plates' plane");
  command.option("max-residual MM", options.max_residual_mm, "parents that lie further apart are not of one part");
  command.option("max-shift MM", options.max_shift_mm, "scans that lie further apart are not of one place");
  command.option("max-turn DEG", options.max_turn_deg, "nor those turned by more");
  command.option("params FILE", options.params,
                 "YAML with the parameters of weld_measurement, in a section of this name or flat; else those that "
                 "BEFORE was measured with");
  command.option("weld-id ID", options.weld_id, "name of the weld in the report; else that of BEFORE");
  command.flag("no-report", options.no_report, "write no report.html and report.png");
  command.arguments("BEFORE AFTER", options.scans, "two folders that scan_bag has filled, or organised PCD clouds");
  command.example("compare_scans --out ground before after");
  command.example("compare_scans --out ground --threshold 0.1 before/scan.pcd after/scan.pcd");
}

CompareParams compareParams(const Options& options)
{
  CompareParams params;
  params.over_ground_limit = kMm * options.threshold_mm;
  params.min_spot_area = kMm * kMm * options.min_area_mm2;
  params.placement = kMm * options.placement_mm;
  params.placement_turn_deg = options.placement_turn_deg;
  params.max_residual = kMm * options.max_residual_mm;
  params.max_shift = kMm * options.max_shift_mm;
  params.max_turn_deg = options.max_turn_deg;
  params.validate();
  return params;
}

WeldParams measuringParams(const Options& options, const CompareSource& before)
{
  if (options.params.empty())
    return before.measuring;
  ParamsFile file(options.params);
  WeldServerParams weld;  // what else the nodelet knows stands in the same file
  file.load("weld_measurement", weld);
  file.refuseUnknown();
  return weld.settings.measuring;
}

ScanComparison compared(const ScanComparer& comparer, const CompareSource& before, const CompareSource& after)
{
  try
  {
    return comparer.compare(before.scan, after.scan);
  }
  catch (const InputError& error)
  {
    throw InputError(before.path + " and " + after.path + " cannot be compared: " + error.what());
  }
}

int compare(const Options& options)
{
  if (options.scans.size() != 2)
    throw UsageError("give two scans, BEFORE and AFTER; " + std::to_string(options.scans.size()) + " were given");
  const CompareParams params = compareParams(options);
  const CompareSource before = readCompareSource(options.scans.front()),
                      after = readCompareSource(options.scans.back());
  throwIfInterrupted();
  const ScanComparer comparer(measuringParams(options, before), params);
  const ScanComparison comparison = compared(comparer, before, after);
  throwIfInterrupted();
  const std::string weld_id = options.weld_id.empty() ? before.weld_id : options.weld_id;
  writeComparison({ before, after, comparison, comparer.measuring(), params, weld_id }, !options.no_report,
                  options.out);
  std::cerr << "compare_scans: " << outcome(comparison) << "\n";
  for (const std::string& note : comparison.notes)
    std::cerr << "compare_scans: " << note << "\n";
  return comparison.measured_share < kLeastShare ? kPoorResult : kGood;
}
}  // namespace
}  // namespace weld_profiler

int main(int argc, char** argv)
{
  weld_profiler::Options options;
  weld_profiler::CommandLine command(
      "compare_scans",
      "Compares the scans of a weld before and after grinding: what was removed, what remains above the target, and\n"
      "where the grinder went deeper than the target. The scans are laid on each other by the parents beside the "
      "weld,\n"
      "so the part may have been taken out and put back (shifted by some mm, turned by some degrees); the scan after\n"
      "needs to show no bead. Leaves compare.json, difference.pcd (organised: x y z after removed remaining) and the\n"
      "report in DIR. The same scans give the same bytes.");
  weld_profiler::declare(command, options);
  return weld_profiler::runCommand(command, argc, argv, [&] { return weld_profiler::compare(options); });
}
