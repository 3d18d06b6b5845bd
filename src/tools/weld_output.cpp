#include "tools/weld_output.h"

#include <filesystem>
#include <iostream>

#include "tools/staged_output.h"

namespace weld_profiler
{
namespace
{
/// One line: kind, verdict, what a reader must know.
std::string outcome(const WeldEvaluation& evaluation)
{
  const WeldResult& result = evaluation.result;
  if (!result.hasWeld())
    return "no weld: " + result.reason;
  std::string text = std::string(name(result.kind)) + ", " + std::to_string(result.sections.size()) + " sections";
  text += ", verdict " + (evaluation.verdict.verdict.empty() ? std::string("none") : evaluation.verdict.verdict);
  if (evaluation.verdict.unverified)
    text += " (rests on limits that were not verified)";
  return text + (result.reason.empty() ? "" : "; " + result.reason);
}
}  // namespace

void measureWelds(const std::vector<Scan>& scans, const WeldTask& task)
{
  const WeldEvaluator evaluator(task.settings);
  for (std::size_t i = 0; i < scans.size(); ++i)
  {
    std::string directory = task.directory;
    if (i > 0)
    {
      directory = (std::filesystem::path(directory) / ("scan_" + std::to_string(i + 1))).string();
      makeOutputDirectory(directory);
    }
    const WeldEvaluation evaluation = evaluator.evaluate(scans[i]);
    writeWeldFiles(scans[i], evaluation, task.settings, task.info, directory);
    if (task.report)
      writeReport(directory);
    std::cerr << "weld " << (scans.size() > 1 ? std::to_string(i + 1) + " " : "") << "in " << directory << ": "
              << outcome(evaluation) << "\n";
  }
}
}  // namespace weld_profiler
