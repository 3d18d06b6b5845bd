#include "tools/dataset_folder.h"
#include "tools/dataset_weld.h"
#include "tools/progress.h"
#include "tools/run_command.h"

namespace weld_profiler
{
namespace
{
constexpr int kMostClouds = 1000000;

struct Options
{
  std::string out;
  int count = 0;
  int seed = 0;
  double validation = 0.2;
};

void declare(CommandLine& command, Options& options)
{
  command.option("out DIR", options.out, "the folder: new, empty, or one that the same command has begun");
  command.required();
  command.option("count N", options.count, "how many clouds in all, 1..1000000");
  command.required();
  command.option("seed S", options.seed, "another seed, other welds; the first N of a seed are always the same");
  command.required();
  command.option("validation SHARE", options.validation,
                 "of the clouds that go to validation/, of all and of each kind, 0..0.9");
  command.example("weld_dataset --out welds --count 1000 --seed 1");
}

void check(const Options& options)
{
  if (options.count < 1 || options.count > kMostClouds)
    throw UsageError("--count is " + std::to_string(options.count) + ", must be in 1.." + std::to_string(kMostClouds));
  if (options.seed < 0)
    throw UsageError("--seed is " + std::to_string(options.seed) + ", must be 0 or more");
  if (!(options.validation >= 0.0 && options.validation <= 0.9))
    throw UsageError("--validation is " + std::to_string(options.validation) + ", must be in 0..0.9");
}

int write(const Options& options)
{
  check(options);
  const DatasetPlan plan{ static_cast<std::uint64_t>(options.seed), options.validation };
  DatasetFolder folder(options.out, plan);
  Progress progress("scanning", static_cast<std::size_t>(options.count));
  try
  {
    for (int index = 0; index < options.count; ++index)
    {
      const DatasetEntry entry = plan.entry(index);
      if (!folder.has(entry))
        folder.add(entry, writeDatasetCloud(entry, folder.path(entry)));
      progress.step();
    }
  }
  catch (const Interrupted&)
  {
    progress.say("weld_dataset: interrupted, the clouds so far are kept; the same command goes on with them");
    return kInterrupted;
  }
  return kGood;
}
}  // namespace
}  // namespace weld_profiler

int main(int argc, char** argv)
{
  weld_profiler::Options options;
  weld_profiler::CommandLine command(
      "weld_dataset",
      "Writes scans of simulated welds with the true label of every point, to train a network with: PCD clouds\n"
      "in train/ and validation/ (x y z intensity sigma stage time flags label removal, organised) and index.csv\n"
      "with each weld's kind and true dimensions. Each weld is rendered and goes through the whole chain, so the\n"
      "clouds have the chain's noise and holes. Interrupted, the same command goes on where it was. The same seed\n"
      "gives the same bytes.");
  weld_profiler::declare(command, options);
  return weld_profiler::runCommand(command, argc, argv, [&] { return weld_profiler::write(options); });
}
