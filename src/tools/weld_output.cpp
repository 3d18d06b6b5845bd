#include "tools/weld_output.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <sstream>

#include "tools/run_command.h"
#include "tools/staged_output.h"
#include "weld_profiler/core/errors.h"

namespace weld_profiler
{
namespace
{
namespace fs = std::filesystem;

constexpr double kMillimetres = 1e3;

/// `bead_on_plate, 144 of 150 sections measured`
std::string measured(const WeldResult& result)
{
  const auto count = std::count_if(result.sections.begin(), result.sections.end(),
                                   [](const WeldSection& section) { return section.hasBead(); });
  return std::string(name(result.kind)) + ", " + std::to_string(count) + " of " +
         std::to_string(result.sections.size()) + " sections measured";
}

/// Beads that were seen and not measured, where the first of them lies.
std::string others(const WeldResult& result)
{
  if (result.other_beads.empty())
    return "";
  const OtherBead& first = result.other_beads.front();
  std::ostringstream text;
  text.precision(3);
  text << "; not measured: another bead at x " << kMillimetres * first.x << " mm, y " << kMillimetres * first.y_from
       << " to " << kMillimetres * first.y_to << " mm";
  if (result.other_beads.size() > 1)
    text << " and " << result.other_beads.size() - 1 << " more";
  return text.str();
}

/// One line: kind, verdict, what a reader must know.
std::string outcome(const WeldEvaluation& evaluation)
{
  const WeldResult& result = evaluation.result;
  if (!result.hasWeld())
    return "no weld: " + result.reason;
  const WeldVerdict& verdict = evaluation.verdict;
  std::string text = measured(result) + ", verdict: " + verdict.text();
  if (verdict.verdict.empty() && verdict.lacks_thickness.empty() && !verdict.notes.empty())
    text += " (" + verdict.notes.front() + ")";
  if (verdict.waiting.sections > 0)
    text += "; " + verdict.waiting.text();
  if (!evaluation.plan.reason.empty())
    text += "; grinding: " + evaluation.plan.reason;
  return text + others(result) + (result.reason.empty() ? "" : "; " + result.reason);
}

fs::path folderOf(const WeldTask& task, std::size_t scan)
{
  return scan == 0 ? fs::path(task.directory) : fs::path(task.directory) / ("scan_" + std::to_string(scan + 1));
}

/// What an interrupted run leaves and lacks, read off the disk: what an earlier run left there is gone by now.
std::string leftBehind(std::size_t scans, const WeldTask& task)
{
  std::string missing, remedy;
  for (std::size_t i = 0; i < scans; ++i)
  {
    const fs::path folder = folderOf(task, i);
    const bool measured = fs::exists(folder / "weld.json");
    if (measured && (!task.report || fs::exists(folder / "report.png")))
      continue;
    missing += (missing.empty() ? "; missing: " : ", ") +
               std::string(measured      ? "the report of "
                           : task.report ? "the weld's files and report of "
                                         : "the weld's files of ") +
               folder.string();
    if (!measured)
      remedy = " (run the command again)";
    else if (remedy.empty())
      remedy = " (weld_report.py " + folder.string() + " draws it)";
  }
  if (missing.empty())
    return "but everything was written before it ended: nothing is missing in " + task.directory;
  return "what is in " + task.directory + " stays and is whole" + missing + remedy;
}

void measureWeld(const Scan& scan, const WeldTask& task, const std::string& directory, const std::string& name)
{
  throwIfInterrupted();
  const WeldEvaluation evaluation = task.evaluator.evaluate(scan);
  writeWeldFiles(scan, evaluation, task.evaluator.settings(), task.info, directory);
  throwIfInterrupted();
  if (task.report)
    runInterruptible([&] { writeReport(directory); });
  throwIfInterrupted();
  std::cerr << name << "in " << directory << ": " << outcome(evaluation) << "\n";
}
}  // namespace

void measureWelds(const std::vector<Scan>& scans, const WeldTask& task)
{
  try
  {
    for (std::size_t i = 0; i < scans.size(); ++i)
    {
      const std::string directory = folderOf(task, i).string();
      makeOutputDirectory(directory);
      measureWeld(scans[i], task, directory, "weld " + (scans.size() > 1 ? std::to_string(i + 1) + " " : ""));
    }
  }
  catch (const Interrupted&)
  {
    throw Interrupted(leftBehind(scans.size(), task));
  }
}
}  // namespace weld_profiler
